"""Inputs that must be refused: (name of the file, bytes). Each gives exit code 3 and a message with file and place."""
import gzip
import struct

from simulations import box

VALID = box(1)


def floor(facets, count=1, more=""):
    """Five points and facets of a rigid surface below the box, in place of the start of SystemParams."""
    return ('<ContactSurface><Nodes NumNodes="5"> 0 0 -1  1 0 -1  1 1 -1  0 -1 -1  0 0 -2 </Nodes>'
            f'<Elements NumEls="{count}" Type="T3"> {facets} </Elements>{more}</ContactSurface><SystemParams>')


def shell(elements, sizes="<Thickness> 0.01 </Thickness>", law='Type="NeoHookean"> 1000'):
    return (f'{elements}<ShellElementSet Size="all"><Material {law} <Density> 1000 </Density>{sizes}</Material>'
            '</ShellElementSet><SystemParams>')


# (name, what is replaced in the valid file, by what)
REPLACED = [
    ("root", "<Model units=\"SI\">", "<Modell units=\"SI\">"),
    ("end_tag", "</SystemParams>", ""),
    ("end_tag_wrong", "</Nodes>\n<Elements", "</Node>\n<Elements"),
    ("units", 'units="SI"', 'units="feet"'),
    ("attribute_misspelt", 'NumNodes="8" DOF', 'NumNode="8" DOF'),
    ("attribute_twice", 'DOF="3"', 'DOF="3" DOF="3"'),
    ("element_misspelt", "<SystemParams>", "<SystemParam/><SystemParams>"),
    ("element_twice", "<SystemParams>", "<SystemParams></SystemParams><SystemParams>"),
    ("node_count", 'NumNodes="8" DOF', 'NumNodes="9" DOF'),
    ("node_count_few", 'NumNodes="8" DOF', 'NumNodes="7" DOF'),
    ("node_count_negative", 'NumNodes="8" DOF', 'NumNodes="-8" DOF'),
    ("node_count_huge", 'NumNodes="8" DOF', 'NumNodes="99999999999" DOF'),
    ("node_count_word", 'NumNodes="8" DOF', 'NumNodes="eight" DOF'),
    ("node_dof", 'DOF="3"', 'DOF="2"'),
    ("node_nan", "0.1 0.1 0.1\n</Nodes>", "0.1 nan 0.1\n</Nodes>"),
    ("node_inf", "0.1 0.1 0.1\n</Nodes>", "0.1 1e400 0.1\n</Nodes>"),
    ("node_word", "0.1 0.1 0.1\n</Nodes>", "0.1 0,1 0.1\n</Nodes>"),
    ("node_glued", "0.1 0.1 0.1\n</Nodes>", "0.1 0.1 0.1x\n</Nodes>"),
    ("element_count", 'NumEls="1"', 'NumEls="2"'),
    ("element_type", 'Type="H8"', 'Type="H20"'),
    ("element_type_absent", ' Type="H8"', ""),
    ("element_index", "0 1 3 2 4 5 7 6", "0 1 3 2 4 5 7 8"),
    ("element_index_negative", "0 1 3 2 4 5 7 6", "-1 1 3 2 4 5 7 6"),
    ("element_flat", "0 1 3 2 4 5 7 6", "0 1 3 2 0 1 3 2"),
    ("element_inverted", "0 1 3 2 4 5 7 6", "4 5 7 6 0 1 3 2"),
    ("element_fraction", "0 1 3 2 4 5 7 6", "0 1 3 2 4 5 7 6.5"),
    ("set_size", 'Size="all"', 'Size="2"'),
    ("set_size_word", 'Size="all"', 'Size="most"'),
    ("set_twice", "<Constraint Type=\"Fix\"", '<ElementSet Size="1">0<Material Type="NH">'
     '<ElasticParams NumParams="2"> 2000 20000 </ElasticParams></Material></ElementSet><Constraint Type="Fix"'),
    ("law", 'Type="NH"', 'Type="NX"'),
    ("law_parameters_few", "> 2000 20000 <", "> 2000 <"),
    ("law_parameters_many", "> 2000 20000 <", "> 2000 20000 1 <"),
    ("law_parameter_count", 'NumParams="2"', 'NumParams="3"'),
    ("law_negative", "> 2000 20000 <", "> -2000 20000 <"),
    ("law_zero", "> 2000 20000 <", "> 0 20000 <"),
    ("law_word", "> 2000 20000 <", "> soft 20000 <"),
    ("law_le_nu", 'Type="NH"><ElasticParams NumParams="2"> 2000 20000', 'Type="LE"><ElasticParams NumParams="2"> 2000 0.5'),
    ("prony_sum", "</ElasticParams>", '</ElasticParams><ViscoParams NumIsoTerms="1" NumVolTerms="0"> 1.2 1 </ViscoParams>'),
    ("prony_tau", "</ElasticParams>", '</ElasticParams><ViscoParams NumIsoTerms="1" NumVolTerms="0"> 0.2 0 </ViscoParams>'),
    ("prony_count", "</ElasticParams>", '</ElasticParams><ViscoParams NumIsoTerms="2" NumVolTerms="0"> 0.2 1 </ViscoParams>'),
    ("density_zero", "<Density> 1000", "<Density> 0"),
    ("density_negative", "<Density> 1000", "<Density> -1"),
    ("density_absent", "<Density> 1000 </Density>", ""),
    ("constraint_type", 'Type="Disp"', 'Type="Displacement"'),
    ("constraint_dof", 'DOF="2" LoadShape', 'DOF="3" LoadShape'),
    ("constraint_shape", "POLY345", "POLY543"),
    ("constraint_shape_absent", ' LoadShape="POLY345"', ""),
    ("constraint_node", "<Nodes> 4 5 6 7 </Nodes>", "<Nodes> 4 5 6 8 </Nodes>"),
    ("constraint_node_count", "<Nodes> 4 5 6 7 </Nodes>", "<Nodes> 4 5 6 </Nodes>"),
    ("constraint_no_nodes", "<Nodes> 4 5 6 7 </Nodes>", ""),
    ("constraint_no_values", '<Magnitudes Type="UNIFORM"> -0.01 </Magnitudes>', ""),
    ("constraint_values_kind", 'Type="UNIFORM"', 'Type="UNIFORMLY"'),
    ("constraint_values_count", '"UNIFORM"> -0.01', '"DIFFORM"> -0.01'),
    ("constraint_value_word", "> -0.01 <", "> -1cm <"),
    ("normal_angle", "<SystemParams>", '<Constraint Type="Fix" SpecType="NORMAL"><Normal ToleranceAngle="200"> 0 0 1 </Normal>'
     "</Constraint><SystemParams>"),
    ("normal_zero", "<SystemParams>", '<Constraint Type="Fix" SpecType="NORMAL"><Normal ToleranceAngle="20"> 0 0 0 </Normal>'
     "</Constraint><SystemParams>"),
    ("normal_empty", "<SystemParams>", '<Constraint Type="Fix" SpecType="NORMAL"><Normal ToleranceAngle="2"> 1 1 1 </Normal>'
     "</Constraint><SystemParams>"),
    ("gravity_direction", "<SystemParams>", '<Constraint Type="Gravity" NumNodes="all" LoadShape="STEP">'
     "<AccelerationMagnitude> 9.81 </AccelerationMagnitude></Constraint><SystemParams>"),
    ("pressure_no_magnitude", "<SystemParams>", '<Constraint Type="Pressure" NumFaces="all" LoadShape="STEP">'
     "</Constraint><SystemParams>"),
    ("file_absent", "<SystemParams>", '<Constraint Type="Disp" DOF="0" NumNodes="8" LoadShape="STEP"><Nodes> 0 </Nodes>'
     '<Magnitudes Type="FILE"> no_such_file.txt </Magnitudes></Constraint><SystemParams>'),
    ("shells_without_set", "<SystemParams>", '<ShellElements Type="SURFACE"/><SystemParams>'),
    ("shell_thickness", "<SystemParams>", shell('<ShellElements Type="SURFACE"/>', "<Thickness> 0 </Thickness>")),
    ("shell_no_area", "<SystemParams>", shell('<ShellElements Type="T3"> 0 1 1 </ShellElements>')),
    ("shell_twice", "<SystemParams>", shell('<ShellElements Type="T3"> 0 1 2  1 2 0 </ShellElements>')),
    ("shell_node", "<SystemParams>", shell('<ShellElements Type="T3"> 0 1 8 </ShellElements>')),
    ("shell_branch", "<SystemParams>", shell('<ShellElements Type="T3"> 0 1 2  0 1 4  0 1 7 </ShellElements>',
                                             law='Type="LinearShell"> 1000 0.3 1000 0.3')),
    ("shell_moebius", "<SystemParams>", shell('<ShellElements Type="T3"> 0 1 2  1 2 3  2 3 4  3 4 0  4 0 1 </ShellElements>')),
    ("contact_surface", "<SystemParams>", "<ContactSurface/><SystemParams>"),
    ("contact_surface_flat", "<SystemParams>", floor("0 1 1")),
    ("contact_surface_fin", "<SystemParams>", floor("0 1 2  1 0 3  0 1 4", 3)),
    ("contact_surface_turned", "<SystemParams>", floor("0 1 2  0 1 3", 2)),
    ("contact_surface_away", "<SystemParams>", floor("0 2 1")),
    ("contact_surface_twice", "<SystemParams>", floor("0 1 2  0 2 1", 2)),
    ("contact_surface_thin", "<SystemParams>", floor("0 1 2  0 2 3  0 3 1  1 3 2", 4)),
    ("contact_surface_far_rate", "<SystemParams>", floor("0 1 2", 1, "<RateConstraintDistance> 0.06 </RateConstraintDistance>")),
    ("contact_surface_friction", "<SystemParams>", floor("0 1 2", 1, "<FrictionCoefficient> -0.1 </FrictionCoefficient>")),
    ("contact_surface_poses", "<SystemParams>", floor("0 1 2", 1,
     '<Motion Type="Poses"><Table> 0 0 0 0 0 0 0  0 0 0 1 0 0 0 </Table></Motion>')),
    ("contact_surface_pose_file", "<SystemParams>", floor("0 1 2", 1,
     '<Motion Type="Poses"><TableFile> nowhere.csv </TableFile></Motion>')),
    ("reduced_basis", "<SystemParams>", '<ReducedBasis NumVectors="1"/><SystemParams>'),
    ("plate_in_the_box", "<SystemParams>", "<ContactPlate><a> -1 -1 0.05 </a><b> -1 1 0.05 </b><c> 1 -1 0.05 </c>"
     "</ContactPlate><SystemParams>"),
    ("cylinder_axis", "<SystemParams>", "<ContactCylinder><Origin> 0 0 0 </Origin><Axis> 0 0 0 </Axis><Radius> 1 </Radius>"
     "<Length> 1 </Length><OrigDisp> 0 0 0 </OrigDisp><RadChange> 0 </RadChange></ContactCylinder><SystemParams>"),
    ("total_time_zero", "<TotalTime> 0.5", "<TotalTime> 0"),
    ("total_time_negative", "<TotalTime> 0.5", "<TotalTime> -1"),
    ("total_time_absent", "<TotalTime> 0.5 </TotalTime>", ""),
    ("total_time_endless", "<TotalTime> 0.5", "<TotalTime> 1e300"),
    ("step_zero", "<TotalTime>", "<TimeStep> 0 </TimeStep><TotalTime>"),
    ("step_word", "<TotalTime>", "<TimeStep> quick </TimeStep><TotalTime>"),
    ("step_tiny", "<TotalTime>", "<TimeStep> 1e-300 </TimeStep><TotalTime>"),
    ("damping_negative", "<DampingCoeff> 10", "<DampingCoeff> -10"),
    ("safety", "<TotalTime>", "<SafetyFactor> -1 </SafetyFactor><TotalTime>"),
    ("output_variable", "<SystemParams>", '<Output Freq="1"><Variable>UU</Variable></Output><SystemParams>'),
    ("output_frequency", "<SystemParams>", '<Output Freq="-1"/><SystemParams>'),
]

WHOLE = [
    ("empty.xml", b""),
    ("binary.xml", bytes(range(256))),
    ("text.xml", b"this is not a simulation\n"),
    ("cut.xml", VALID[: len(VALID) // 2].encode()),
    ("utf16.xml", VALID.encode("utf-16")),
    ("deep.xml", b"<Model>" + b"<SubModel>" * 20000),
    ("empty.msh", b""),
    ("version.msh", b"$MeshFormat\n9.9 0 8\n$EndMeshFormat\n"),
    ("count.msh", b"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n99999999999\n1 0 0 0\n$EndNodes\n"),
    ("index.msh", b"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n"
                  b"$Elements\n1\n1 4 2 0 0 1 2 3 5\n$EndElements\n"),
    ("cut.msh", b"$MeshFormat\n4.1 1 8\n\x01\x00\x00\x00\n$EndMeshFormat\n$Nodes\n\x01\x00"),
    ("empty.vtk", b""),
    ("header.vtk", b"# vtk DataFile Version 9.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n0 0 0\n"),
    ("kind.vtk", b"# vtk DataFile Version 3.0\nx\nASCII\nDATASET STRUCTURED_POINTS\n"),
    ("cut.vtu", b'<?xml version="1.0"?><VTKFile type="UnstructuredGrid"><UnstructuredGrid>'),
    ("kind.vtu", b'<?xml version="1.0"?><VTKFile type="PolyData"></VTKFile>'),
    ("facets.stl", b"solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0\n"),
    ("count.stl", b"\0" * 80 + struct.pack("<I", 4000000000)),
    ("header.ply", b"ply\nformat ascii 1.0\nelement vertex 3\n"),
    ("index.off", b"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"),
    ("index.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n"),
    ("empty.nii", b""),
    ("cut.nii.gz", gzip.compress(b"\0" * 400)[:30]),
    ("size.nii", struct.pack("<i", 348) + b"\0" * 344),
    ("empty.inr", b""),
    ("header.inr", b"#INRIMAGE-4#{\nXDIM=1000000\nYDIM=1000000\nZDIM=1000000\n##}\n"),
    ("cut.inr", b"#INRIMAGE-4#{\nXDIM=4\nYDIM=4\nZDIM=4\nVDIM=1\nTYPE=unsigned fixed\nPIXSIZE=8 bits\nCPU=decm\n"
                b"VX=1\nVY=1\nVZ=1\n" + b"\n" * 100 + b"##}\n"),
]


def files():
    for name, old, new in REPLACED:
        assert VALID.count(old) >= 1, f"{name}: {old!r} is not in the valid file"
        yield name + ".xml", VALID.replace(old, new, 1).encode()
    yield from WHOLE
