// A small valid simulation file that the format tests edit, and helpers to read one.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include <glisson/core/base/error.hpp>
#include <glisson/models/format/read_model.hpp>

namespace glisson::test {

/// A unit cube of 5 tetrahedra, fixed at z = 0 and pulled at z = 1.
inline const std::string base_xml = R"(<?xml version="1.0"?>
<Model>
  <Nodes NumNodes="8" DOF="3">
    0 0 0  1 0 0  1 1 0  0 1 0
    0 0 1  1 0 1  1 1 1  0 1 1
  </Nodes>
  <Elements NumEls="5" Type="T4">
    0 1 3 4  1 2 3 6  1 6 4 5  3 4 6 7  1 3 4 6
  </Elements>
  <ElementSet Size="all">
    <Material Type="NH">
      <ElasticParams NumParams="2">1000 50000</ElasticParams>
      <Density>1000</Density>
    </Material>
  </ElementSet>
  <Constraint Type="Fix" DOF="all" NumNodes="4">
    <Nodes>0 1 2 3</Nodes>
  </Constraint>
  <Constraint Type="Disp" DOF="2" LoadShape="POLY345" SpecType="NORMAL">
    <Normal ToleranceAngle="10">0 0 1</Normal>
    <Magnitudes Type="UNIFORM">0.1</Magnitudes>
  </Constraint>
  <SystemParams>
    <TimeStep>0.001</TimeStep>
    <TotalTime>1</TotalTime>
    <DampingCoeff>5</DampingCoeff>
  </SystemParams>
</Model>
)";

inline std::string replaced(std::string text, const std::string& what, const std::string& with) {
  const auto at = text.find(what);
  if (at == std::string::npos) ADD_FAILURE() << "the base file does not hold: " << what;
  return at == std::string::npos ? text : text.replace(at, what.size(), with);
}

/// The base file with more children of Model before SystemParams.
inline std::string with(const std::string& more) {
  return replaced(base_xml, "  <SystemParams>", more + "  <SystemParams>");
}

inline Model parsed(const std::string& xml, std::vector<std::string>* warnings = nullptr) {
  return parse_model(xml, "test.xml", {.allow_files = false, .warnings = warnings});
}

inline std::string message_of(const std::string& xml) {
  try {
    parsed(xml);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace glisson::test
