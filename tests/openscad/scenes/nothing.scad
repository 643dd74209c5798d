// All is cut away: an empty picture, not an error.
difference() {
    cube(5);
    cube(5);
}
