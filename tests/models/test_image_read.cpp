// Label images in every stored type, byte order and transform come out the same.
#include <gtest/gtest.h>

#include <fstream>

#include "tests/models/image_files.hpp"
#include "tests/models/output_samples.hpp"

namespace glisson {
namespace {

using Affine = std::array<std::array<double, 4>, 3>;

void expect_counting(const LabelImage& image) {
  EXPECT_EQ(image.size, (std::array{2, 3, 4}));
  EXPECT_EQ(image.labels, counting<std::int32_t>(24));
  EXPECT_EQ(image.label(1, 2, 3), 23);
}

template <class T>
void check_type(int code) {
  for (const int version : {1, 2})
    for (const bool swap : {false, true}) {
      NiftiFile file(version, swap);
      const Bytes bytes = file.type(code, 8 * static_cast<int>(sizeof(T))).with(counting<T>(24));
      expect_counting(parse_label_image(bytes, "plain.nii"));
      expect_counting(parse_label_image(zipped(bytes), "packed.nii.gz"));
    }
}

TEST(ImageNifti, EveryTypeVersionAndByteOrderGivesTheSameLabels) {
  check_type<std::uint8_t>(2);
  check_type<std::int16_t>(4);
  check_type<std::int32_t>(8);
  check_type<float>(16);
  check_type<double>(64);
  check_type<std::int8_t>(256);
  check_type<std::uint16_t>(512);
  check_type<std::uint32_t>(768);
  check_type<std::int64_t>(1024);
  check_type<std::uint64_t>(1280);
}

TEST(ImageNifti, NegativeAndLargeLabelsSurvive) {
  NiftiFile file;
  file.size(3, {3, 1, 1}).type(8, 32);
  const std::vector<std::int32_t> labels{-2147483647, 0, 2147483647};
  EXPECT_EQ(parse_label_image(file.with(labels), "a.nii").labels, labels);
}

TEST(ImageNifti, TransformsAreTriedInTheOrderOfTheStandard) {
  for (const int version : {1, 2}) {
    NiftiFile file(version);
    file.pixdim(1, 0.5).pixdim(2, 2).pixdim(3, 3);
    const Bytes voxels = counting<std::uint8_t>(24);
    EXPECT_EQ(parse_label_image(NiftiFile(file).with(voxels), "a").to_world,
              (Affine{{{0.5, 0, 0, 0}, {0, 2, 0, 0}, {0, 0, 3, 0}}}));
    // 90 degrees about z, third axis mirrored: x = -2 j + 7, y = 0.5 i + 8, z = -3 k + 9.
    const double half = std::sqrt(0.5);
    file.code(252, 344, 1).pixdim(0, -1).real(256, 352, 0).real(260, 360, 0).real(264, 368, half);
    file.real(268, 376, 7).real(272, 384, 8).real(276, 392, 9);
    const Affine turned = parse_label_image(NiftiFile(file).with(voxels), "a").to_world;
    const Affine expected{{{0, -2, 0, 7}, {0.5, 0, 0, 8}, {0, 0, -3, 9}}};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(turned[i][k], expected[i][k], 1e-6);
    file.sform({-1, 0, 0, 10, 0, 2, 0.25, 20, 0, 0, 3, 30});
    EXPECT_EQ(parse_label_image(NiftiFile(file).with(voxels), "a").to_world,
              (Affine{{{-1, 0, 0, 10}, {0, 2, 0.25, 20}, {0, 0, 3, 30}}}));
  }
}

TEST(ImageNifti, MetresAndMicrometresBecomeMillimetres) {
  NiftiFile metres(1), micrometres(2);
  metres.put<char>(123, 1).pixdim(1, 0.5);
  micrometres.put<std::int32_t>(500, 3 + 8).pixdim(1, 500);
  EXPECT_DOUBLE_EQ(parse_label_image(metres.with(counting<std::uint8_t>(24)), "a").to_world[0][0], 500);
  EXPECT_DOUBLE_EQ(parse_label_image(micrometres.with(counting<std::uint8_t>(24)), "a").to_world[0][0], 0.5);
}

TEST(ImageNifti, ScalingIsHonouredWhereItGivesWholeNumbers) {
  NiftiFile file;
  file.real(112, 176, 0.1).real(116, 184, -1);
  Bytes voxels = counting<std::uint8_t>(24);
  for (auto& v : voxels) v = static_cast<unsigned char>(10 * v);
  const auto labels = parse_label_image(NiftiFile(file).with(voxels), "a").labels;
  EXPECT_EQ(labels[0], -1);
  EXPECT_EQ(labels[23], 22);
  file.real(112, 176, std::nan(""));  // as some writers mark "none"
  expect_counting(parse_label_image(NiftiFile(file).with(counting<std::uint8_t>(24)), "a"));
}

TEST(ImageNifti, FlatImagesSingleVolumesAndExtensionsAreRead) {
  NiftiFile flat;
  EXPECT_EQ(parse_label_image(flat.size(2, {4, 6, 0}).with(counting<std::uint8_t>(24)), "a").size,
            (std::array{4, 6, 1}));
  NiftiFile four;
  expect_counting(parse_label_image(four.size(4, {2, 3, 4, 1}).with(counting<std::uint8_t>(24)), "a"));
  NiftiFile extended;
  Bytes bytes = extended.put<float>(108, 368).bytes();
  bytes.insert(bytes.end(), 16, 7);
  for (unsigned char v = 0; v < 24; ++v) bytes.push_back(v);
  expect_counting(parse_label_image(bytes, "a"));
}

const std::string inr_lines = "XDIM=2\nYDIM=3\nZDIM=4\nVDIM=1\nVX=0.5\nVY=2\nVZ=3\n";

TEST(ImageInr, EveryTypeAndByteOrderGivesTheSameLabels) {
  const auto little = [](std::size_t width) {
    Bytes voxels(24 * width);
    for (std::size_t i = 0; i < 24; ++i) voxels[i * width] = static_cast<unsigned char>(i);
    return voxels;
  };
  const auto big = [](std::size_t width) {
    Bytes voxels(24 * width);
    for (std::size_t i = 0; i < 24; ++i) voxels[i * width + width - 1] = static_cast<unsigned char>(i);
    return voxels;
  };
  for (const char* sign : {"unsigned", "signed"})
    for (const std::size_t width : {1u, 2u, 4u, 8u}) {
      const std::string type =
          inr_lines + "TYPE=" + sign + " fixed\nPIXSIZE=" + std::to_string(8 * width) + " bits\n";
      expect_counting(parse_label_image(inr_file(type + "CPU=decm\nSCALE=2**0\n", little(width)), "a.inr"));
      expect_counting(parse_label_image(zipped(inr_file(type + "CPU=sun\n", big(width))), "a.inr.gz"));
    }
  const auto reals = counting<float>(24);
  Bytes raw(96);
  std::memcpy(raw.data(), reals.data(), 96);
  const LabelImage image = parse_label_image(
      inr_file(inr_lines + "# a comment\r\nTYPE=float\nPIXSIZE=32 bits\nCPU=pc\n", raw), "a.inr");
  expect_counting(image);
  EXPECT_EQ(image.to_world, (Affine{{{0.5, 0, 0, 0}, {0, 2, 0, 0}, {0, 0, 3, 0}}}));
}

TEST(ImageInr, LongHeadersAndPowersOfTwoAreRead) {
  const std::string more =
      inr_lines + "#" + std::string(400, 'c') + "\nTYPE=unsigned fixed\nPIXSIZE=8\nSCALE=2**3\nTX=5\n";
  const LabelImage image = parse_label_image(inr_file(more, counting<std::uint8_t>(24)), "a.inr");
  EXPECT_EQ(image.label(1, 2, 3), 8 * 23);
  EXPECT_EQ(image.to_world[0][3], 5);
}

TEST(ImageFile, IsReadFromDiskByContent) {
  const OwnFolder folder;
  NiftiFile file;
  const Bytes bytes = zipped(file.with(counting<std::uint8_t>(24)));
  std::ofstream(folder.path / "organ", std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  expect_counting(read_label_image(folder.path / "organ"));
}

}  // namespace
}  // namespace glisson
