// Eyes and mouth are islands in a hole, and so is the middle of the second sign.
linear_extrude(3) text("\u263A\u25C9", size = 20, font = "DejaVu Sans", $fn = 16);
