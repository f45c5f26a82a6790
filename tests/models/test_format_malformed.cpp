// Files one edit away from a valid one: each must be refused with the right line and a word that helps.
#include <tests/models/format_base.hpp>

namespace glisson::test {
namespace {

struct Bad {
  const char* what;  ///< text of the base file
  const char* with;  ///< what it becomes
  int line;
  const char* word;  ///< of the message
};

#define FLOOR(elements, more)                                                                    \
  "<ContactSurface><Nodes NumNodes=\"4\">0 0 -1 1 0 -1 1 1 -1 0 1 -1</Nodes><Elements " elements \
  "</Elements>" more "</ContactSurface><SystemParams>"

#define SHELLS(elements, sets) elements sets "<SystemParams>"
#define SKIN "<ShellElements Type=\"SURFACE\"/>"
#define MATERIAL_ONLY "<Material Type=\"NeoHookean\">1<Density>1</Density><Thickness>1</Thickness></Material>"
#define MATERIAL(type, content) \
  "<ShellElementSet Size=\"all\"><Material Type=\"" type "\">" content "</Material></ShellElementSet>"
#define SHELL(type, content) MATERIAL(type, content "<Density>1</Density><Thickness>1</Thickness>")

const Bad bad_files[] = {
    // XML
    {"<Model>", "<Model", 2, "XML"},
    {"</Model>", "", 2, "end tag missing"},
    {"</Nodes>", "</Node>", 3, "closed by another name"},
    {"NumEls=\"5\"", "NumEls=5", 7, "name=\"value\""},
    {"DOF=\"3\"", "DOF=\"3\" dof=\"3\"", 3, "twice"},
    {"</Model>", "</Model><Model/>", 28, "second root"},
    {"<Model>", "<!-- <Model>", 2, "XML"},
    // names
    {"<ElementSet ", "<ElementSett ", 10, "XML"},
    {"<DampingCoeff>5</DampingCoeff>", "<DampingCoef>5</DampingCoef>", 26, "did you mean DampingCoeff?"},
    {"<Density>1000</Density>", "<Densty>1000</Densty>", 13, "did you mean Density?"},
    {"DOF=\"2\"", "DOFS=\"2\"", 19, "did you mean DOF?"},
    {"LoadShape=", "LoadShap=", 19, "did you mean LoadShape?"},
    {"<Normal ToleranceAngle", "<Normal Tolerance", 20, "unknown attribute Tolerance"},
    {"SpecType=\"NORMAL\"", "SpecType=\"NORMALS\"", 19, "did you mean NORMAL?"},
    {"Type=\"NH\"", "Type=\"NHH\"", 11, "did you mean"},
    {"Type=\"Disp\"", "Type=\"Displ\"", 19, "did you mean Disp?"},
    {"POLY345", "POLY35", 19, "did you mean POLY345?"},
    {"<SystemParams>", "<Qwertyuiop/><SystemParams>", 23, "known here"},
    {"<Elements ", "<Elements Typ=\"T4\" ", 7, "did you mean Type?"},
    {"</SystemParams>", "</SystemParams><SystemParams/>", 27, "second one"},
    {"<SystemParams>", "stray <SystemParams>", 2, "text 'stray'"},
    // geometry
    {" NumNodes=\"8\"", "", 3, "NumNodes is missing"},
    {"NumNodes=\"8\"", "NumNodes=\"eight\"", 3, "whole number"},
    {"NumNodes=\"8\"", "NumNodes=\"9\"", 3, "24 coordinates"},
    {"NumNodes=\"8\"", "NumNodes=\"-8\"", 3, "24"},
    {"NumNodes=\"8\"", "NumNodes=\"99999999999\"", 3, "whole number"},
    {"DOF=\"3\"", "DOF=\"2\"", 3, "DOF=\"2\""},
    {"0 0 1  1 0 1", "0 0 1  1 O 1", 5, "'O' is not a finite number"},
    {"0 0 1  1 0 1", "0 0 nan  1 0 1", 5, "'nan'"},
    {"0 0 1  1 0 1", "0 0 1e999  1 0 1", 5, "'1e999'"},
    {"0 0 1  1 0 1", "0 0 1,  1 0 1", 5, "'1,'"},
    {"1 3 4 6\n", "1 3 4 6 7\n", 7, "ends within element"},
    {"NumEls=\"5\"", "NumEls=\"6\"", 7, "lists 5 elements"},
    {"1 3 4 6\n", "1 3 4 8\n", 7, "uses node 8"},
    {"1 3 4 6\n", "1 3 4 -6\n", 7, "uses node -6"},
    {"1 3 4 6\n", "1 3 4.0 6\n", 8, "'4.0' is not a whole number"},
    {"Type=\"T4\"", "Type=\"T5\"", 7, "did you mean T4"},
    {"Type=\"T4\"", "Type=\"T4+T4ANP\"", 7, "same shape"},
    {"Type=\"T4\"", "Type=\"T4+\"", 7, "not an element type"},
    {"Type=\"T4\"", "Type=\"AUTO\"", 7, "4 or 8"},
    {"Type=\"T4\"", "", 7, "Type is missing"},
    {"<Nodes NumNodes=\"8\" DOF=\"3\">", "<MSHMesh>a.msh</MSHMesh><Nodes NumNodes=\"8\">", 3,
     "second geometry"},
    // sets and materials
    {"Size=\"all\"", "", 10, "Size is missing"},
    {"Size=\"all\"", "Size=\"some\"", 10, "whole number"},
    {"Size=\"all\"", "Size=\"2\"", 10, "lists 0 elements"},
    {"Size=\"all\">", "Size=\"2\">0 5", 10, "index 5"},
    {"Size=\"all\">", "Size=\"9\">0", 10, "index 8"},
    {"Size=\"all\">", "Size=\"all\">0 1", 10, "holds no list"},
    {"Size=\"all\">", "Label=\"7\">", 10, "no element has Label=\"7\""},
    {"Size=\"all\">", "Label=\"x\">", 10, "whole number"},
    {"Size=\"all\">", "Size=\"all\" Label=\"0\">", 10, "Size and Label"},
    {"Size=\"all\">", "Size=\"all\" Formulation=\"H8\">", 10, "does not fit element 0"},
    {"NumParams=\"2\"", "NumParams=\"3\"", 12, "holds 2 parameters"},
    {"NumParams=\"2\">1000", "NumParams=\"1\">", 12, "needs 2 parameters (mu kappa)"},
    {" NumParams=\"2\"", "", 12, "NumParams is missing"},
    {"Type=\"NH\"", "Type=\"TI\"", 12, "needs 6 parameters (mu kappa eta a1 a2 a3)"},
    {"Type=\"NH\"", "Type=\"NHV\"", 11, "needs <ViscoParams>"},
    {"<Density>1000</Density>", "", 11, "no density"},
    {"<Density>1000</Density>", "<Density></Density>", 13, "0 numbers"},
    {"<Density>", "<ViscoParams NumIsoTerms=\"1\" NumVolTerms=\"1\">0.1 1 0.2</ViscoParams><Density>", 13,
     "need 2 each"},
    {"<Density>", "<ViscoParams NumIsoTerms=\"1\">0.1 1</ViscoParams><Density>", 13,
     "NumVolTerms is missing"},
    {"<Density>", "<ElementArray Param=\"mu\">stiffness</ElementArray><Density>", 13,
     "no cell array 'stiffness'"},
    {"<Density>", "<ElementArray Param=\"nu\">stiffness</ElementArray><Density>", 13, "did you mean mu?"},
    {"<Density>", "<FibreArray>fibres</FibreArray><Density>", 13, "no fibre direction"},
    // constraints
    {" NumNodes=\"4\"", " NumNodes=\"3\"", 17, "lists 4 nodes"},
    {"0 1 2 3</Nodes>", "0 1 2 8</Nodes>", 17, "index 8"},
    {"<Nodes>0 1 2 3</Nodes>", "", 16, "needs the element <Nodes>"},
    {"<Nodes>0 1 2 3</Nodes>", "<Nodes>5</Nodes>", 17, "index 8"},
    {" NumNodes=\"4\"", " NumNodes=\"all\"", 17, "beside NumNodes"},
    {" LoadShape=\"POLY345\"", "", 19, "LoadShape is missing"},
    {"LoadShape=\"POLY345\"", "LoadShape=\"TABLE\"", 19, "belong together"},
    {"<Magnitudes Type=\"UNIFORM\">", "<Table>0 1 0 2</Table><Magnitudes Type=\"UNIFORM\">", 19,
     "belong together"},
    {"ToleranceAngle=\"10\"", "ToleranceAngle=\"-10\"", 20, "0 and 180"},
    {"ToleranceAngle=\"10\"", "", 20, "ToleranceAngle is missing"},
    {">0 0 1</Normal>", ">0 0 0</Normal>", 20, "no direction"},
    {">0 0 1</Normal>", ">0 1</Normal>", 20, "2 numbers where 3"},
    {">0 0 1</Normal>", ">1 1 1</Normal>", 19, "selection is empty"},
    {"<Normal ToleranceAngle=\"10\">0 0 1</Normal>", "", 19, "needs the element <Normal>"},
    {"Type=\"UNIFORM\"", "Type=\"DIFFORM\"", 21, "4 are needed"},
    {"Type=\"UNIFORM\"", "Type=\"CONSTANT\"", 21, "known here"},
    {"Type=\"UNIFORM\">0.1", "Type=\"UNIFORM\">0.1 0.2", 21, "2 numbers where 1"},
    {"Type=\"UNIFORM\">0.1", "Type=\"FILE\">values.txt", 21, "files are not allowed"},
    {"<Magnitudes Type=\"UNIFORM\">0.1</Magnitudes>", "", 19, "<Magnitudes> is missing"},
    {"DOF=\"2\"", "DOF=\"3\"", 19, "DOF=\"3\""},
    {"SpecType=\"NORMAL\"", "SpecType=\"NORMAL\" StartTime=\"1\" EndTime=\"0.5\"", 19, "before StartTime"},
    {"<Magnitudes", "<RestrictTo Type=\"Box\">0 1 0 1 1</RestrictTo><Magnitudes", 21, "5 numbers where 6"},
    {"<Magnitudes", "<RestrictTo Type=\"Box\">1 0 0 1 0 1</RestrictTo><Magnitudes", 21, "above its maximum"},
    {"<Magnitudes", "<RestrictTo Type=\"Ball\">1 0 0 1</RestrictTo><Magnitudes", 21, "RestrictTo"},
    {"<Magnitudes", "<Sphere>-1 0 0 1</Sphere><Magnitudes", 21, "not positive"},
    {"<Magnitudes", "<HalfSpace>0 0 0 0 0 0</HalfSpace><Magnitudes", 21, "zero vector"},
    {"<Magnitudes", "<Distance>a.stl</Distance><Magnitudes", 21, "Max is missing"},
    {"<Magnitudes", "<Distance Max=\"1\">a.stl</Distance><Magnitudes", 21, "files are not allowed"},
    {"<Magnitudes", "<Select Op=\"xor\"/><Magnitudes", 21, "Op=\"xor\""},
    {"<Magnitudes", "<Select Op=\"or\"/><Magnitudes", 21, "nothing to combine"},
    {"SpecType=\"NORMAL\"", "SpecType=\"NORMAL\" NumFaces=\"all\"", 19, "belongs to Pressure"},
    // time
    {"<TimeStep>0.001", "<TimeStep>0", 24, "greater than 0"},
    {"<TimeStep>0.001", "<TimeStep>fast", 24, "'fast'"},
    {"<TimeStep>0.001", "<TimeStep>2", 24, "longer than TotalTime"},
    {"<TotalTime>1</TotalTime>", "", 23, "<TotalTime> is missing"},
    {"<TotalTime>1", "<TotalTime>-1", 25, "greater than 0"},
    {"<TotalTime>1", "<TotalTime>1 2", 25, "2 numbers where 1"},
    {"<DampingCoeff>5", "<DampingCoeff>-5", 26, "not be negative"},
    {"<DampingCoeff>", "<TimeStepper>Euler</TimeStepper><DampingCoeff>", 26, "'Euler' is not a time stepper"},
    {"<DampingCoeff>", "<SafetyFactor>2</SafetyFactor><DampingCoeff>", 26, "above 1"},
    {"<DampingCoeff>", "<MonitorFreq>-1</MonitorFreq><DampingCoeff>", 26, "0 to 1e9"},
    {"<DampingCoeff>", "<QuasiStatic><MaxSteps>0</MaxSteps></QuasiStatic><DampingCoeff>", 26, "at least 1"},
    {"<DampingCoeff>", "<QuasiStatic><ForceTol>1</ForceTol></QuasiStatic><DampingCoeff>", 26,
     "did you mean ForceTolerance?"},
    // not built
    {"<DampingCoeff>", "<ROM>1</ROM><DampingCoeff>", 26, "not supported yet"},
    // membranes and shells
    {"<SystemParams>", SHELLS("<ShellElements/>", ""), 23, "Type is missing"},
    {"<SystemParams>", SHELLS("<ShellElements Type=\"SURFAC\"/>", ""), 23, "did you mean SURFACE?"},
    {"<SystemParams>", SHELLS("<ShellElements Type=\"T3\"/>", ""), 23, "0 numbers"},
    {"<SystemParams>", SHELLS("<ShellElements Type=\"T3\">0 1 2 3</ShellElements>", ""), 23, "4 numbers"},
    {"<SystemParams>", SHELLS("<ShellElements Type=\"T3\" NumEls=\"2\">0 1 2</ShellElements>", ""), 23,
     "2 facets"},
    {"<SystemParams>", SHELLS("<ShellElements Type=\"T3\">0 1 8</ShellElements>", ""), 23, "uses node 8"},
    {"<SystemParams>", SHELLS("<ShellElements Type=\"T3\">0 1 -1</ShellElements>", ""), 23, "uses node -1"},
    {"<SystemParams>", SHELLS("<ShellElements Type=\"T3\">0 1 two</ShellElements>", ""), 23, "'two'"},
    {"<SystemParams>", SHELLS("<ShellElements Type=\"T3\">0 1 1</ShellElements>", ""), 23, "node 1 twice"},
    {"<SystemParams>", SHELLS("<ShellElements Type=\"T3\">0 1 2  0 2 3  2 0 1</ShellElements>", ""), 23,
     "shell triangle 2: it has the same nodes as triangle 0"},
    {"<SystemParams>", SHELLS("<ShellElements Type=\"SURFACE\">0 1 2</ShellElements>", ""), 23,
     "holds no list"},
    {"<SystemParams>", SHELLS("<ShellElements Type=\"SURFACE\" Label=\"3\"/>", ""), 23,
     "no element has Label=\"3\""},
    {"<SystemParams>", SHELLS("<ShellElements Type=\"SURFACE\"><Sphere>1 9 9 9</Sphere></ShellElements>", ""),
     23, "no facet is in the selection"},
    {"<SystemParams>", SHELLS("<ShellElements Type=\"MESH\"/>", ""), 23, "mesh file"},
    {"<SystemParams>", SHELLS("<ShellElements Type=\"FILE\">a.stl</ShellElements>", ""), 23,
     "files are not allowed"},
    {"<SystemParams>", SHELLS("<ShellElements Type=\"T3\" Label=\"1\">0 1 2</ShellElements>", ""), 23,
     "no labels"},
    {"<SystemParams>",
     SHELLS("<ShellElements Type=\"SURFACE\"><ScaleFactor>2</ScaleFactor></ShellElements>", ""), 23,
     "can be moved"},
    {"<SystemParams>",
     SHELLS("<ShellElements Type=\"T3\">0 1 2  0 1 3  0 1 4</ShellElements>",
            SHELL("LinearShell", "1 0.3 1 0.3")),
     23, "more than two triangles"},
    {"<SystemParams>", SHELLS("", SHELL("NeoHookean", "1000")), 23, "no shell triangles"},
    {"<SystemParams>", SHELLS(SKIN, "<ShellElementSet/>"), 23, "Size is missing"},
    {"<SystemParams>", SHELLS(SKIN, "<ShellElementSet Size=\"13\">0</ShellElementSet>"), 23, "index 12"},
    {"<SystemParams>", SHELLS(SKIN, "<ShellElementSet Size=\"2\">0 99</ShellElementSet>"), 23, "index 99"},
    {"<SystemParams>", SHELLS(SKIN, "<ShellElementSet Size=\"all\">0 1</ShellElementSet>"), 23,
     "holds no list"},
    {"<SystemParams>", SHELLS(SKIN, "<ShellElementSet Size=\"all\"/>"), 23, "<Material> is missing"},
    {"<SystemParams>", SHELLS(SKIN, SHELL("NeoHookean", "1000") SHELL("NeoHookean", "1000")), 23,
     "in another set already"},
    {"<SystemParams>", SHELLS(SKIN, SHELL("NeoHokean", "1000")), 23, "did you mean NeoHookean?"},
    {"<SystemParams>", SHELLS(SKIN, SHELL("NeoHookean", "1000 5")), 23, "needs 1 parameters (mu)"},
    {"<SystemParams>", SHELLS(SKIN, SHELL("LinearShell", "1000 0.3")), 23, "E nu, then E nu of bending"},
    {"<SystemParams>", SHELLS(SKIN, SHELL("NeoHookean", "")), 23, "needs 1 parameters"},
    {"<SystemParams>", SHELLS(SKIN, SHELL("NeoHookean", "-1")), 23, "the parameter mu is -1"},
    {"<SystemParams>", SHELLS(SKIN, SHELL("Linear", "1000 0.6")), 23, "the parameter nu is 0.6"},
    {"<SystemParams>", SHELLS(SKIN, SHELL("LinearShell", "1000 0.3 -1 0.3")), 23, "bending stiffness"},
    {"<SystemParams>", SHELLS(SKIN, SHELL("TwoFibre", "1000 1 1 30")), 23, "add <FibreDirection>"},
    {"<SystemParams>", SHELLS(SKIN, MATERIAL("NeoHookean", "1000<Density>1</Density>")), 23,
     "<Thickness> is missing"},
    {"<SystemParams>", SHELLS(SKIN, MATERIAL("NeoHookean", "1000<Thickness>1</Thickness>")), 23,
     "no density"},
    {"<SystemParams>",
     SHELLS(SKIN, MATERIAL("NeoHookean", "1000<Density>1</Density><Thickness>0</Thickness>")), 23,
     "greater than 0"},
    {"<SystemParams>",
     SHELLS(SKIN, MATERIAL("NeoHookean", "1000<Density>-1</Density><Thickness>1</Thickness>")), 23,
     "greater than 0"},
    {"<SystemParams>", SHELLS(SKIN, MATERIAL("NeoHookean", "1000<Density>1</Density><Thicknes>1</Thicknes>")),
     23, "did you mean Thickness?"},
    {"<SystemParams>", SHELLS(SKIN, SHELL("NeoHookean", "1<ViscoParams NumTerms=\"2\">0.5 1</ViscoParams>")),
     23, "2 for each"},
    {"<SystemParams>", SHELLS(SKIN, SHELL("NeoHookean", "1<ViscoParams NumTerms=\"1\">1.5 1</ViscoParams>")),
     23, "alphas sum"},
    {"<SystemParams>",
     SHELLS(SKIN, SHELL("NeoHookean", "1<ElementArray Param=\"Thickness\">h</ElementArray>")), 23,
     "no cell array 'h'"},
    {"<SystemParams>", SHELLS(SKIN, SHELL("NeoHookean", "1<ElementArray Param=\"Thick\">h</ElementArray>")),
     23, "did you mean Thickness?"},
    {"<SystemParams>",
     SHELLS(SKIN, SHELL("TwoFibre\" Wrinkling=\"1", "1 1 1 0<FibreDirection>1 0 0</FibreDirection>")), 23,
     "wrinkling needs"},
    {"<SystemParams>", SHELLS(SKIN, SHELL("NeoHookean", "1<FibreDirection>0 0 0</FibreDirection>")), 23,
     "no direction"},
    {"<SystemParams>",
     SHELLS(SKIN, "<ShellElementSet Size=\"all\">" MATERIAL_ONLY
                  "<ClampedNodes>8</ClampedNodes></ShellElementSet>"),
     23, "index 8"},
    {"<SystemParams>",
     SHELLS(SKIN, "<ShellElementSet Size=\"all\">" MATERIAL_ONLY "<ClampedNodes/></ShellElementSet>"), 23,
     "names no node"},
    {"NumNodes=\"4\">\n    <Nodes>", "FaceType=\"Shell\">\n    <Nodes>", 16, "FaceType=\"Shell\""},
    // rigid surfaces
    {"<SystemParams>", "<ContactSurface/><SystemParams>", 23, "<Nodes> is missing"},
    {"<SystemParams>",
     FLOOR("NumEls=\"1\" Type=\"T3\">0 1 2", "<FrictionCoefficient>-1</FrictionCoefficient>"), 23,
     "must not be negative"},
    {"<SystemParams>",
     FLOOR("NumEls=\"1\" Type=\"T3\">0 1 2", "<FrictionCoefficient>nan</FrictionCoefficient>"), 23,
     "'nan' is not a finite number"},
    {"<SystemParams>", FLOOR("NumEls=\"1\" Type=\"T3\">0 1 2", "<FrictionCoeficient>1</FrictionCoeficient>"),
     23, "did you mean FrictionCoefficient?"},
    {"<SystemParams>", FLOOR("NumEls=\"1\" Typ=\"T3\">0 1 2", ""), 23, "did you mean Type?"},
    {"<SystemParams>", FLOOR("NumEls=\"1\" Type=\"T3\">0 1 2", "<Motion>0 0 1</Motion>"), 23,
     "Type is missing"},
    {"<SystemParams>",
     FLOOR("NumEls=\"1\" Type=\"T3\">0 1 2", "<Motion Type=\"Translation\">0 0 inf</Motion>"), 23,
     "'inf' is not a finite number"},
    {"<SystemParams>", FLOOR("NumEls=\"1\" Type=\"T3\">0 1 2", "<SlvNodes>0 8</SlvNodes>"), 23, "index 8"},
    {"<SystemParams>", FLOOR("NumEls=\"1\" Type=\"T3\">0 1 2", "<SurfaceFile>a.stl</SurfaceFile>"), 23,
     "second geometry"},
    {"<SystemParams>", FLOOR("NumEls=\"1\" Type=\"T3\">0 1 4", ""), 23, "node 4"},
    {"<SystemParams>", FLOOR("NumEls=\"2\" Type=\"T3\">0 1 2", ""), 23, "NumEls"},
    {"<SystemParams>", FLOOR("NumEls=\"1\" Type=\"T6\">0 1 2", ""), 23, "T3 or Q4"},
    {"<SystemParams>", FLOOR("NumEls=\"1\" Type=\"T3\">0 1 2", "<Motion Type=\"Rotation\">1 2 3</Motion>"),
     23, "6"},
    {"<SystemParams>", FLOOR("NumEls=\"1\" Type=\"T3\">0 1 2", "<SlaveNodes>8</SlaveNodes>"), 23, "8"},
    {"<SystemParams>",
     FLOOR("NumEls=\"1\" Type=\"T3\">0 1 2", "<RateConstraintDistance>-1</RateConstraintDistance>"), 23,
     "must not be negative"},
    {"<SystemParams>",
     "<ContactSurface><SurfaceFile>a.stl</SurfaceFile><VTKSurface>b.vtk</VTKSurface></"
     "ContactSurface><SystemParams>",
     23, "a second geometry: <SurfaceFile> is there too"},
    {"<SystemParams>", "<ContactSurface Response=\"Penalti\"/><SystemParams>", 23, "did you mean Penalty?"},
    {"<SystemParams>", "<KinematicContact/><SystemParams>", 23, "not supported yet"},
    {"<SystemParams>", "<ReducedBasis NumVectors=\"3\"/><SystemParams>", 23, "not supported yet"},
    // contact of deformable bodies
    {"<DampingCoeff>", "<DoSelfCollision>yes</DoSelfCollision><DampingCoeff>", 26, "whole number"},
    {"<DampingCoeff>", "<DeformableFrictionCoefficient>-1</DeformableFrictionCoefficient><DampingCoeff>", 26,
     "must not be negative"},
    {"<DampingCoeff>", "<ContactSafetyMargin>-1</ContactSafetyMargin><DampingCoeff>", 26,
     "must not be negative"},
    {"<DampingCoeff>", "<RateConstraintDistance>-1</RateConstraintDistance><DampingCoeff>", 26,
     "must not be negative"},
    {"<DampingCoeff>", "<ContactResponse Type=\"Penalty\" Stiffness=\"2\"/><DampingCoeff>", 26, "at most 1"},
    {"<DampingCoeff>", "<ContactResponse Type=\"Penalty\" Stiffness=\"0\"/><DampingCoeff>", 26,
     "greater than 0"},
    {"<DampingCoeff>", "<ContactResponse Type=\"Penalty\" Stiffness=\"nan\"/><DampingCoeff>", 26,
     "Stiffness"},
    {"<DampingCoeff>", "<ContactResponse Stiffness=\"0.5\"/><DampingCoeff>", 26, "belongs to Type"},
    {"<DampingCoeff>", "<BVType>AAB</BVType><DampingCoeff>", 26, "did you mean AABB?"},
    {"<DampingCoeff>", "<DoSelfColision>1</DoSelfColision><DampingCoeff>", 26,
     "did you mean DoSelfCollision?"},
    {"<DampingCoeff>", "<ContactSafetyMargin>nan</ContactSafetyMargin><DampingCoeff>", 26, "'nan'"},
    {"<SystemParams>", "<ContactPair A=\"x\"/><SystemParams>", 23, "B is missing"},
    {"<SystemParams>", "<ContactPair A=\"x\" B=\"y\" Tuch=\"0\"/><SystemParams>", 23, "did you mean Touch?"},
    {"<SystemParams>", "<ContactPair A=\"x\" B=\"y\"/><SystemParams>", 23, "no SubModel has Name=\"x\""},
    {"<SystemParams>", "<ContactPair A=\"x\" B=\"y\" Touch=\"2\"/><SystemParams>", 23, "Touch"},
    {"<SystemParams>", "<TiedSurfaces A=\"x\"/><SystemParams>", 23, "B is missing"},
    {"<SystemParams>", "<TiedSurfaces A=\"x\" B=\"y\"/><SystemParams>", 23, "no SubModel has Name=\"x\""},
    {"<SystemParams>", "<TiedSurfaces A=\"x\" B=\"x\"/><SystemParams>", 23, "two different sub-models"},
    {"<SystemParams>", "<TiedSurfaces A=\"x\" B=\"y\" Distance=\"0\"/><SystemParams>", 23, "greater than 0"},
    {"<SystemParams>", "<TiedSurfaces A=\"x\" B=\"y\" Distance=\"far\"/><SystemParams>", 23, "Distance"},
    {"<SystemParams>", "<ContactNodes/><SystemParams>", 23, "empty"},
    {"<SystemParams>", "<ContactNodes>0 8</ContactNodes><SystemParams>", 23, "index 8"},
    // bodies, sub-models, output
    {"<SystemParams>", "<ContactPlate><a>0 0 0</a><b>1 0 0</b></ContactPlate><SystemParams>", 23,
     "<c> is missing"},
    {"<SystemParams>", "<ContactPlate><a>0 0 0</a><b>1 0 0</b><c>2 0 0</c></ContactPlate><SystemParams>", 23,
     "one line"},
    {"<SystemParams>",
     "<ContactPlate><a>0 0 0</a><b>1 0 0</b><c>0 1 0</c><FrictionCoefficient>-1</FrictionCoefficient>"
     "</ContactPlate><SystemParams>",
     23, "must not be negative"},
    {"<SystemParams>",
     "<ContactCylinder><Origin>0 0 0</Origin><Axis>0 0 0</Axis></ContactCylinder><SystemParams>", 23,
     "no direction"},
    {"<SystemParams>",
     "<ContactUSProbe><Origin>0 0 0</Origin><Axis>0 0 "
     "1</Axis><Radius>0</Radius></ContactUSProbe><SystemParams>",
     23, "greater than 0"},
    {"<SystemParams>", "<SubModel><Output Freq=\"1\"/></SubModel><SystemParams>", 23,
     "unknown element in <SubModel>"},
    {"<SystemParams>", "<SubModel/><SystemParams>", 23, "<Nodes> is missing"},
    {"<SystemParams>", "<Output Freq=\"-1\"/><SystemParams>", 23, "negative"},
    {"<SystemParams>", "<Output Freq=\"1\"><Variable>W</Variable></Output><SystemParams>", 23,
     "not a variable"},
    {"<Model>", "<Model units=\"cm\">", 2, "units=\"cm\""},
    {"<Model>\n", "<Simulation>\n", 2, "XML"},
};

TEST(FormatMalformed, EachIsRefusedWithPlaceAndReason) {
  EXPECT_GE(std::size(bad_files), 60U);
  for (const auto& bad : bad_files) {
    const auto xml = replaced(base_xml, bad.what, bad.with);
    try {
      parsed(xml);
      ADD_FAILURE() << "accepted: " << bad.what << " -> " << bad.with;
    } catch (const Error& error) {
      const std::string message = error.what();
      EXPECT_EQ(error.kind(), ErrorKind::input);
      EXPECT_EQ(error.place().file, "test.xml");
      EXPECT_EQ(error.place().line, bad.line) << bad.what << " -> " << bad.with << "\n  " << message;
      EXPECT_NE(message.find(bad.word), std::string::npos) << message << "\n  lacks: " << bad.word;
    }
  }
}

TEST(FormatMalformed, OddDocumentsAreRefused) {
  for (const auto& xml :
       {std::string(), std::string("   "), std::string("no xml"), std::string("<Simulation/>"),
        std::string("<Model/>"), std::string("<Model>\0</Model>", 16), std::string("<?xml version=\"1.0\"?>"),
        std::string("<Model><SystemParams><TotalTime>1</TotalTime></SystemParams></Model>")})
    EXPECT_THROW(parsed(xml), Error) << xml;
  std::string deep;
  for (int i = 0; i < 5000; ++i) deep += "<SubModel>";
  EXPECT_THROW(parsed("<Model>" + deep), Error);
}

TEST(FormatMalformed, EveryPrefixOfAFileIsRefused) {
  for (std::size_t length = 0; length + 2 < base_xml.size(); length += 7)
    EXPECT_THROW(parsed(base_xml.substr(0, length)), Error) << length;
}

}  // namespace
}  // namespace glisson::test
