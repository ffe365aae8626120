// A slope of sand, 4 m high, 4 m wide at the crest and 1 : 2 at its face, in 2D,
// with air above and ahead of it. y up. Triangles; the sand is a region of its
// own.
//
// Made by gmsh 4.8.4 (another version gives another mesh of the same kind):
//   gmsh -2 -nt 1 slope_2d.geo -o slope_2d.msh
//     1634 nodes, 3086 triangles, altitude 0.08627 m (smallest), 0.20587 m (mean), hull 81 m2

DefineConstant[ size = 0.25 ];

length = 18;
height = 4.5;
sand_height = 4;
crest = 4;
toe = 12;

Point(1) = {0, 0, 0, size};
Point(2) = {toe, 0, 0, size};
Point(3) = {length, 0, 0, size};
Point(4) = {length, height, 0, size};
Point(5) = {0, height, 0, size};
Point(6) = {0, sand_height, 0, size};
Point(7) = {crest, sand_height, 0, size};

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
Physical Curve("ground", 1) = {1, 2};
Physical Curve("back", 2) = {5, 6};
Physical Curve("ahead", 3) = {3};
Physical Curve("above", 4) = {4};

Mesh.Algorithm = 6; // frontal Delaunay triangles
Mesh.MshFileVersion = 4.1;
