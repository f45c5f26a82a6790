// SystemParams and Output: time settings, defaults of sections, what is written.
#include <glisson/models/format/reader.hpp>
#include <glisson/models/format/suggest.hpp>

#include <algorithm>

namespace glisson::detail {

double positive_number(const XmlElement& element) {
  const double value = element.number();
  if (!(value > 0)) element.fail("it is " + element.text() + ", but must be greater than 0");
  return value;
}

namespace {

void refuse_unbuilt(const XmlElement& system) {
  if (const auto element = system.child("ROM"); element != nullptr && element->integer() != 0)
    element->fail("this feature is not supported yet; set it to 0 to run without it");
}

Stepper stepper_named(const XmlElement& element) {
  const auto name = element.required_text();
  if (name == "CDM") return Stepper::central_difference;
  if (name == "Newmark") return Stepper::newmark;
  element.fail("'" + name + "' is not a time stepper" + suggestion(name, {"CDM", "Newmark"}));
}

QuasiStatic read_quasi_static(const XmlElement& element) {
  QuasiStatic settings;
  if (const auto child = element.child("ForceTolerance")) settings.force_tolerance = positive_number(*child);
  if (const auto child = element.child("DisplacementTolerance"))
    settings.displacement_tolerance = positive_number(*child);
  if (const auto child = element.child("MaxSteps")) {
    settings.max_steps = child->integer();
    if (settings.max_steps < 1) child->fail("it is " + child->text() + ", but must be at least 1");
  }
  return settings;
}

void read_times(const XmlElement& system, TimeSettings& time) {
  if (const auto child = system.child("QuasiStatic")) time.quasi_static = read_quasi_static(*child);
  if (const auto child = system.child("TotalTime"))
    time.total = positive_number(*child);
  else if (!time.quasi_static)
    system.required_child("TotalTime");
  if (const auto child = system.child("TimeStep"); child != nullptr && child->required_text() != "auto")
    time.step = positive_number(*child);
  if (time.step && time.total > 0 && *time.step > time.total)
    system.child("TimeStep")
        ->fail("a step of " + system.child("TimeStep")->text() + " is longer than TotalTime");
}

}  // namespace

void read_system_params(Reader& reader, const XmlElement& model, TimeSettings& time) {
  const auto& system = model.required_child("SystemParams");
  refuse_unbuilt(system);
  read_times(system, time);
  if (const auto child = system.child("DampingCoeff")) time.damping = not_negative(*child);
  if (const auto child = system.child("SafetyFactor")) {
    time.safety = positive_number(*child);
    if (time.safety > 1)
      child->fail("it is " + child->text() + ": above 1 the step is not stable; use 0.5 to 0.9");
  }
  if (const auto child = system.child("TimeStepper")) time.stepper = stepper_named(*child);
  if (const auto child = system.child("MassScaling")) time.mass_scaling_step = positive_number(*child);
  if (const auto child = system.child("EnergyTolerance")) time.energy_tolerance = child->number();
  if (const auto child = system.child("MonitorFreq")) {
    const auto every = child->integer();
    if (every < 0 || every > 1'000'000'000)
      child->fail("it is " + child->text() + ", but must be 0 to 1e9 steps");
    time.monitor_every = static_cast<int>(every);
  }
  if (const auto child = system.child("Density")) reader.density = positive_number(*child);
  if (const auto child = system.child("HGKappa")) reader.hourglass = not_negative(*child);
  reader.total_time = time.total > 0 ? time.total : pseudo_time;
}

void read_output(const XmlElement& model, OutputSettings& output) {
  const auto element = model.child("Output");
  if (element == nullptr) return;
  output.every = element->integer_attribute("Freq").value_or(0);
  if (output.every < 0)
    element->fail("Freq=\"" + std::to_string(output.every) +
                  "\" is negative; give the steps between snapshots");
  const std::vector<std::string> known{"U", "F", "S", "E", "EKin", "EStrain"};
  for (const auto variable : element->all("Variable")) {
    const auto name = variable->required_text();
    if (std::find(known.begin(), known.end(), name) == known.end())
      variable->fail("'" + name + "' is not a variable" + suggestion(name, known));
    output.variables.push_back(name);
  }
}

}  // namespace glisson::detail
