rotate_extrude($fn=60) translate([20,0]) circle(r=5,$fn=24);
translate([60,0,0]) rotate_extrude(angle=120,$fn=48) translate([10,0]) polygon([[0,0],[8,0],[8,3],[3,3],[3,12],[8,14],[8,16],[0,16]]);
translate([0,60,0]) rotate_extrude(angle=270,$fn=32) translate([10,0]) square([5,9]);
translate([60,60,0]) rotate_extrude($fn=7) difference(){ polygon([[0,0],[15,0],[10,20],[0,25]]); translate([0,8]) circle(4,$fn=20);}
translate([-60,0,0]) rotate_extrude(angle=-80,$fn=45) translate([-10,0]) circle(6,$fn=9);
translate([-60,60,0]) rotate_extrude($fn=45) intersection(){ circle(15,$fn=30); translate([0,-20]) square([20,40]); }
translate([0,-60,0]) rotate_extrude($fn=25) { translate([0,0]) square([4,20]); translate([0,18]) square([12,3]); translate([12,20]) circle(3);}
