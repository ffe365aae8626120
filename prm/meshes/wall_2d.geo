// Half of a wall of dry sand before its collapse, in 2D: sand 1 x 2 m in a
// domain 4.2 x 2.2 m. x = 0 is the plane of symmetry, y up. Triangles; the sand
// is a region of its own.
//
// Made by gmsh 4.8.4 (another version gives another mesh of the same kind):
//   gmsh -2 -nt 1 wall_2d.geo -o wall_2d.msh
//     4451 nodes, 8644 triangles, altitude 0.02582 m (smallest), 0.04239 m (mean), hull 9.24 m2

DefineConstant[ size = 0.05 ];

length = 4.2;
height = 2.2;
sand_length = 1;
sand_height = 2;

Point(1) = {0, 0, 0, size};
Point(2) = {sand_length, 0, 0, size};
Point(3) = {length, 0, 0, size};
Point(4) = {length, height, 0, size};
Point(5) = {0, height, 0, size};
Point(6) = {0, sand_height, 0, size};
Point(7) = {sand_length, sand_height, 0, size};

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

Physical Surface("sand", 1) = {1};
Physical Surface("air", 2) = {2};
Physical Curve("x_min", 1) = {5, 6};
Physical Curve("x_max", 2) = {3};
Physical Curve("y_min", 3) = {1, 2};
Physical Curve("y_max", 4) = {4};

Mesh.Algorithm = 6; // frontal Delaunay triangles
Mesh.MshFileVersion = 4.1;
