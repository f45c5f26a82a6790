#include <glisson/models/format/schema.hpp>

#include <glisson/models/format/read_model.hpp>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace glisson::detail {
namespace {

#define GLISSON_LEAVES                                                                                 \
  "Nodes=Nodes* Normal=Normal* Box=Value* Sphere=Value* HalfSpace=Value* Label=Value* Surface=Empty* " \
  "All=Empty* "                                                                                        \
  "Distance=Distance* Select=Select* "

constexpr std::array rules{
    ElementRule{
        "Model", "units:SI,mm-kg-s",
        "Nodes=MeshNodes Elements=MeshElements MSHMesh=MeshFile VTKMesh=MeshFile VTUMesh=MeshFile "
        "Mesh=MeshFile "
        "ElementSet=ElementSet* Constraint=Constraint* SubModel=SubModel* SubModelNodeMergerDistance=Value "
        "ContactCylinder=Cylinder* ContactUSProbe=Cylinder* ContactPlate=Plate* Output=Output "
        "SystemParams=SystemParams ShellElements=ShellElements* ShellElementSet=ShellElementSet* "
        "ContactSurface=ContactSurface* ContactPair=ContactPair* ContactNodes=Nodes "
        "TiedSurfaces=TiedSurfaces* "
        "KinematicContact=NotBuilt* ReducedBasis=NotBuilt"},
    ElementRule{
        "SubModel", "Name",
        "Nodes=MeshNodes Elements=MeshElements MSHMesh=MeshFile VTKMesh=MeshFile VTUMesh=MeshFile "
        "Mesh=MeshFile "
        "ElementSet=ElementSet* Constraint=Constraint* SubModel=SubModel* SubModelNodeMergerDistance=Value "
        "ShellElements=ShellElements* ShellElementSet=ShellElementSet*"},
    ElementRule{"MeshNodes", "NumNodes DOF:3", "", true},
    ElementRule{"MeshElements", "NumEls Type", "", true},
    ElementRule{"MeshFile", "Type", "Translation=Value Rotation=Value ScaleFactor=Value", true},
    ElementRule{"ElementSet", "Name Size Label Formulation:T4,T4ANP,H8,H8FixedHourglass,H8Full",
                "Material=Material", true},
    ElementRule{
        "Material", "Type:LE,NH,AB,PY,TI,OG,NHV,TIV",
        "ElasticParams=ElasticParams ViscoParams=ViscoParams Density=Value ElementArray=ElementArray* "
        "FibreArray=Value"},
    ElementRule{"ElasticParams", "NumParams", "", true},
    ElementRule{"ViscoParams", "NumIsoTerms NumVolTerms", "", true},
    ElementRule{"ElementArray", "Param", "", true},
    ElementRule{"ShellElements", "Type:T3,Q4,SURFACE,MESH,FILE NumEls Label",
                GLISSON_LEAVES "RestrictTo=RestrictTo* Translation=Value Rotation=Value ScaleFactor=Value",
                true},
    ElementRule{"ShellElementSet", "Name Size Label",
                GLISSON_LEAVES "RestrictTo=RestrictTo* Material=ShellMaterial ClampedNodes=ClampedNodes*",
                true},
    ElementRule{"ShellMaterial",
                "Type:Linear,NeoHookean,NeoHookeanCompressible,Fung,TwoFibre,LinearShell,LinearThickShell,"
                "NeoHookeanShell,NeoHookeanCompressibleShell Wrinkling:0,1",
                "Density=Value Thickness=Value ViscoParams=ShellViscoParams FibreDirection=Value "
                "FibreArray=Value ElementArray=ElementArray*",
                true},
    ElementRule{"ShellViscoParams", "NumTerms", "", true},
    ElementRule{"ClampedNodes", "NumNodes", GLISSON_LEAVES "RestrictTo=RestrictTo*", true},
    ElementRule{
        "Constraint",
        "Type:Fix,Disp,Force,Gravity,Pressure,Traction,Spring,SlidingPlane,Symmetry,InitialVelocity "
        "Name DOF:0,1,2,all LoadShape:POLY345,RAMP,RAMPHOLD,STEP,HILLY,TABLE NumNodes "
        "SpecType:NODES,NORMAL,BOX,SPHERE,HALFSPACE,LABEL,SURFACE,DISTANCE,SELECT NumFaces "
        "FaceType:Tri,Quad,Shell "
        "StartTime EndTime Release:0,1 TargetLoadShape:POLY345,RAMP,RAMPHOLD,STEP,HILLY,TABLE",
        GLISSON_LEAVES
        "RestrictTo=RestrictTo* Faces=Value Magnitudes=Magnitudes Magnitude=Value "
        "AccelerationMagnitude=Value "
        "AccelerationDirection=Value Table=Value TargetTable=Value Stiffness=Magnitudes Targets=Magnitudes "
        "StrainEnergyCap=Value PlaneNormal=Value Velocity=Value"},
    ElementRule{"Magnitudes", "Type:UNIFORM,DIFFORM,FILE", "", true},
    ElementRule{"Select", "Op:and,or,not", GLISSON_LEAVES},
    ElementRule{"RestrictTo",
                "Type:Box,Sphere,HalfSpace,Normal,Label,Nodes,Surface,Distance Invert:0,1 ToleranceAngle Max",
                "", true},
    ElementRule{"Nodes", "NumNodes", "", true},
    ElementRule{"Normal", "ToleranceAngle", "", true},
    ElementRule{"Distance", "Max", "", true},
    ElementRule{
        "Cylinder", "LoadShape:POLY345,RAMP,RAMPHOLD,STEP,HILLY,TABLE StartTime EndTime",
        "Origin=Value Axis=Value Radius=Value Length=Value OrigDisp=Value RadChange=Value SlvNodes=Nodes "
        "Table=Value FrictionCoefficient=Value"},
    ElementRule{"Plate", "LoadShape:POLY345,RAMP,RAMPHOLD,STEP,HILLY,TABLE StartTime EndTime",
                "a=Value b=Value c=Value Disp=Value SlvNodes=Nodes Table=Value FrictionCoefficient=Value"},
    ElementRule{"ContactSurface", "Response:Multiplier,Penalty Stiffness",
                "Nodes=MeshNodes Elements=MeshElements VTKSurface=MeshFile SurfaceFile=MeshFile "
                "FrictionCoefficient=Value RateConstraintDistance=Value SlaveNodes=Nodes SlvNodes=Nodes "
                "Motion=Motion"},
    ElementRule{"ContactPair", "A B Touch:0,1", "FrictionCoefficient=Value"},
    ElementRule{"TiedSurfaces", "A B Distance", ""},
    ElementRule{
        "Motion",
        "Type:Translation,Rotation,Poses LoadShape:POLY345,RAMP,RAMPHOLD,STEP,HILLY,TABLE StartTime EndTime "
        "Rotation:Vector,Quaternion,None",
        "Table=Value TableFile=Value Centre=Value", true},
    ElementRule{"Output", "Freq", "Variable=Value*"},
    ElementRule{
        "SystemParams", "",
        "TimeStep=Value TotalTime=Value DampingCoeff=Value Density=Value HGKappa=Value ROM=Value "
        "DoDeformableCollision=Collision DoSelfCollision=Collision DoMultiPassContacts=Value BVType=Value "
        "DeformableFrictionCoefficient=Value ContactSafetyMargin=Value RateConstraintDistance=Value "
        "SafetyFactor=Value TimeStepper=Value MassScaling=Value QuasiStatic=QuasiStatic "
        "EnergyTolerance=Value ContactResponse=ContactResponse "
        "MonitorFreq=Value"},
    ElementRule{"Collision", "Type", "", true},
    ElementRule{"ContactResponse", "Type:Multiplier,Penalty Stiffness", ""},
    ElementRule{"QuasiStatic", "", "ForceTolerance=Value DisplacementTolerance=Value MaxSteps=Value"},
    ElementRule{"Value", "", "", true},
    ElementRule{"Empty", "", ""},
    ElementRule{not_built, "", "", true},
};
#undef GLISSON_LEAVES

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(separator), text.size());
    if (end > 0) parts.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return parts;
}

}  // namespace

std::span<const ElementRule> element_rules() { return rules; }

const ElementRule& rule_of(std::string_view kind) {
  for (const auto& rule : rules)
    if (rule.kind == kind) return rule;
  throw std::logic_error("the grammar names the kind " + std::string(kind) + " but has no rule for it");
}

std::vector<AttributeRule> attributes_of(const ElementRule& rule) {
  std::vector<AttributeRule> result;
  for (const auto entry : split(rule.attributes, ' ')) {
    const auto colon = std::min(entry.find(':'), entry.size());
    AttributeRule attribute{std::string(entry.substr(0, colon)), {}};
    if (colon < entry.size())
      for (const auto value : split(entry.substr(colon + 1), ',')) attribute.values.emplace_back(value);
    result.push_back(attribute);
  }
  return result;
}

std::vector<ChildRule> children_of(const ElementRule& rule) {
  std::vector<ChildRule> result;
  for (auto entry : split(rule.children, ' ')) {
    ChildRule child;
    child.repeatable = entry.back() == '*';
    if (child.repeatable) entry.remove_suffix(1);
    child.name = entry.substr(0, entry.find('='));
    child.kind = entry.substr(entry.find('=') + 1);
    result.push_back(child);
  }
  return result;
}

}  // namespace glisson::detail

namespace glisson {

std::vector<std::string> known_names() {
  std::vector<std::string> names{std::string(detail::root_kind)};
  for (const auto& rule : detail::element_rules()) {
    for (const auto& attribute : detail::attributes_of(rule)) names.push_back(attribute.name);
    for (const auto& child : detail::children_of(rule)) names.push_back(child.name);
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

}  // namespace glisson
