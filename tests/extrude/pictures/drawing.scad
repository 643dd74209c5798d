difference() { square(20, center=true); color("red") circle(4); }
translate([25,0,3]) color("blue") circle(8);
translate([0,25]) offset(r=2) square(8);
%translate([25,25]) square(5);
translate([-20,0]) text("Abc");
