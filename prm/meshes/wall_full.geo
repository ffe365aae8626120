// A wall of dry sand before its collapse, both halves: sand 2 x 0.2 x 2 m in a
// domain 8.4 x 0.2 x 2.2 m. y is the thickness of the slice, z up. Tetrahedra;
// the sand is a region of its own. The mesh is its own mirror image in x = 0,
// and its right half is the mesh of wall.geo.
//
// Made by gmsh 4.8.4 (another version gives another mesh of the same kind; the
// warnings about ANN support do not matter):
//   gmsh -3 -nt 1 wall_full.geo -o wall_full.msh
//     21320 nodes, 98832 tetrahedra, altitude 0.03166 m (smallest), 0.03877 m (mean), hull 3.696 m3

DefineConstant[ size = 0.074, layers = 4 ];

length = 4.2;
height = 2.2;
thickness = 0.2;
sand_length = 1;
sand_height = 2;

// The right half, x > 0.
Point(1) = {0, 0, 0, size};
Point(2) = {sand_length, 0, 0, size};
Point(3) = {length, 0, 0, size};
Point(4) = {length, 0, height, size};
Point(5) = {0, 0, height, size};
Point(6) = {0, 0, sand_height, size};
Point(7) = {sand_length, 0, sand_height, size};

Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 6};
Line(6) = {6, 1};
Line(7) = {2, 7};
Line(8) = {7, 6};

Curve Loop(1) = {1, 7, 8, 6};
Plane Surface(1) = {1};
Curve Loop(2) = {2, 3, 4, 5, -8, -7};
Plane Surface(2) = {2};

// The left half; the numbers of its points and lines are larger by 10.
Point(12) = {-sand_length, 0, 0, size};
Point(13) = {-length, 0, 0, size};
Point(14) = {-length, 0, height, size};
Point(17) = {-sand_length, 0, sand_height, size};

Line(11) = {1, 12};
Line(12) = {12, 13};
Line(13) = {13, 14};
Line(14) = {14, 5};
Line(17) = {12, 17};
Line(18) = {17, 6};

Curve Loop(3) = {-6, -18, -17, -11};
Plane Surface(3) = {3};
Curve Loop(4) = {17, 18, -5, -14, -13, -12};
Plane Surface(4) = {4};

// The triangles of the left half are the mirrored ones of the right half.
Periodic Surface {3} = {1} Affine {-1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1};
Periodic Surface {4} = {2} Affine {-1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1};

// Extrude gives the far surface, the volume, and the surfaces swept by the
// curves of the loop in their order.
right_sand[] = Extrude {0, thickness, 0} { Surface{1}; Layers{layers}; };
right_air[] = Extrude {0, thickness, 0} { Surface{2}; Layers{layers}; };
left_sand[] = Extrude {0, thickness, 0} { Surface{3}; Layers{layers}; };
left_air[] = Extrude {0, thickness, 0} { Surface{4}; Layers{layers}; };

Physical Volume("sand", 1) = {right_sand[1], left_sand[1]};
Physical Volume("air", 2) = {right_air[1], left_air[1]};
Physical Surface("x_min", 1) = {left_air[6]};
Physical Surface("x_max", 2) = {right_air[3]};
Physical Surface("y_min", 3) = {1, 2, 3, 4};
Physical Surface("y_max", 4) = {right_sand[0], right_air[0],
                                left_sand[0], left_air[0]};
Physical Surface("z_min", 5) = {right_sand[2], right_air[2],
                                left_sand[5], left_air[7]};
Physical Surface("z_max", 6) = {right_air[4], left_air[5]};

Mesh.Algorithm = 6; // frontal Delaunay triangles
Mesh.MshFileVersion = 4.1;
