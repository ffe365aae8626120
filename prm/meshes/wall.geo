// Half of a wall of dry sand before its collapse: sand 1 x 0.2 x 2 m in a domain
// 4.2 x 0.2 x 2.2 m. x = 0 is the plane of symmetry, y the thickness of the
// slice, z up. Tetrahedra; the sand is a region of its own.
//
// The plane y = 0 is meshed by Delaunay triangles, which are extruded into
// layers of prisms, and each prism is cut into three tetrahedra. In a slice
// this thin that gives a smallest altitude half as large again as a mesh that
// is unstructured in all directions, and the explicit time step is proportional
// to it. With layers = 0 the mesh is unstructured in all directions.
//
// Made by gmsh 4.8.4 (another version gives another mesh of the same kind):
//   gmsh -3 -nt 1 wall.geo -o wall.msh
//     10740 nodes, 49416 tetrahedra, altitude 0.03166 m (smallest), 0.03877 m (mean), hull 1.848 m3
//   gmsh -3 -nt 1 wall.geo -setnumber layers 0 -setnumber size 0.059 -o wall_unstructured.msh
//     11332 nodes, 45456 tetrahedra, altitude 0.02161 m (smallest), 0.04550 m (mean), hull 1.848 m3
//   gmsh -3 -nt 1 wall.geo -setnumber layers 0 -setnumber size 0.098 -o wall_coarse.msh
//     3366 nodes, 11583 tetrahedra, altitude 0.03058 m (smallest), 0.07146 m (mean), hull 1.848 m3

DefineConstant[ size = 0.074, layers = 4 ];

length = 4.2;
height = 2.2;
thickness = 0.2;
sand_length = 1;
sand_height = 2;

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

// Extrude gives the far surface, the volume, and the surfaces swept by the
// curves of the loop in their order.
If (layers > 0)
  sand[] = Extrude {0, thickness, 0} { Surface{1}; Layers{layers}; };
  air[] = Extrude {0, thickness, 0} { Surface{2}; Layers{layers}; };
Else
  sand[] = Extrude {0, thickness, 0} { Surface{1}; };
  air[] = Extrude {0, thickness, 0} { Surface{2}; };
EndIf

Physical Volume("sand", 1) = {sand[1]};
Physical Volume("air", 2) = {air[1]};
Physical Surface("x_min", 1) = {sand[5], air[5]};
Physical Surface("x_max", 2) = {air[3]};
Physical Surface("y_min", 3) = {1, 2};
Physical Surface("y_max", 4) = {sand[0], air[0]};
Physical Surface("z_min", 5) = {sand[2], air[2]};
Physical Surface("z_max", 6) = {air[4]};

Mesh.Algorithm = 6;   // frontal Delaunay triangles
Mesh.Algorithm3D = 1; // Delaunay tetrahedra (layers = 0)
Mesh.OptimizeThreshold = 0.7;
Mesh.MshFileVersion = 4.1;
