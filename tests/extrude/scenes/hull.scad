$fn=24;
hull(){ cube([10,5,3]); translate([20,10,5]) sphere(4); }
translate([40,0,0]) hull() for(x=[0,20],y=[0,12]) translate([x,y,0]) cylinder(r=3,h=6);
translate([0,40,0]) difference(){ hull(){ translate([0,0,0]) cylinder(r1=8,r2=3,h=10); translate([20,0,0]) rotate([0,90,0]) cylinder(r=4,h=8);} translate([5,0,-1]) cylinder(r=2,h=30);}
translate([40,40,0]) hull(){ difference(){ sphere(10); translate([-20,-20,-20]) cube([40,40,25]); } translate([15,0,0]) linear_extrude(5) difference(){circle(6); translate([0,-10]) square(20);} }
translate([-40,0,0]) minkowski(){ cube([10,10,4]); cylinder(r=3,h=1); }
translate([-40,40,0]) minkowski(){ difference(){ cube([15,15,4]); translate([4,4,-1]) cube([7,7,10]);} sphere(2,$fn=12); }
translate([-40,-40,0]) hull(){ rotate_extrude() translate([8,0]) circle(2); translate([0,0,15]) sphere(1); }
translate([0,-40,0]) hull(){ hull(){cube(3); translate([10,0,0]) cube(2);} translate([0,12,0]) sphere(3,$fn=80);}
