$fn=24;
linear_extrude(4) offset(r=3) square([20,10]);
translate([40,0,0]) linear_extrude(4) offset(r=-2) difference(){ square([30,20]); translate([10,5]) square([5,8]); }
translate([0,40,0]) linear_extrude(4) offset(delta=2) polygon([[0,0],[20,0],[10,5],[20,20],[0,20]]);
translate([40,40,0]) linear_extrude(4) offset(delta=2,chamfer=true) polygon([[0,0],[20,0],[10,5],[20,20],[0,20]]);
translate([-40,0,0]) linear_extrude(4) hull(){ circle(5); translate([20,3]) circle(2); translate([0,15]) square(3); }
translate([-40,40,0]) linear_extrude(4) offset(r=2) offset(delta=-2) union(){ square([20,5],center=true); square([5,20],center=true); circle(6);}
translate([-40,-40,0]) linear_extrude(4) difference(){ offset(r=2) circle(10); circle(10);}
translate([0,-40,0]) linear_extrude(4) offset(delta=-1) polygon([[0,0],[20,0],[10,5],[20,20],[0,20]]);
translate([40,-40,0]) rotate_extrude() translate([8,0]) offset(r=1) square([4,9]);
translate([70,-40,0]) linear_extrude(5) hull(){ difference(){circle(10); translate([0,-10]) square(20);} }
