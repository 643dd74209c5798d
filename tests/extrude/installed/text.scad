// One linear_extrude, so that OpenSCAD needs no Boolean of solids.
linear_extrude(2) {
    text("Hello, Wörld @8&B%");
    translate([0, -15]) text("Right", halign = "right", font = "Liberation Serif:style=Italic",
                             spacing = 1.2, $fn = 40);
    translate([40, -15]) text("cent", halign = "center", valign = "center",
                              font = " Liberation Mono:style=Bold ", size = 8);
    translate([70, -5]) text("ttb", direction = "ttb", valign = "top", size = 8);
    translate([80, -15]) rotate(20) scale([1, 0.5]) difference() {
        square([20, 12]);
        translate([2, 2]) text("a\"b\\Q", size = 7);
    }
    translate([40, -40]) text("fi AV To", valign = "bottom", font = "NoSuchFont", $fn = 5);
    translate([0, -40]) text("سلام", size = 12);
    text("");
    text("nothing", size = 0);
}
