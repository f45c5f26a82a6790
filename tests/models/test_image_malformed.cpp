// Broken and hostile image files: each gives Error(input) with the file's name and says what is wrong.
#include <gtest/gtest.h>

#include "tests/models/image_files.hpp"
#include "tests/models/output_samples.hpp"

namespace glisson {
namespace {

struct Broken {
  Bytes bytes;
  std::string says;
};

void expect_refused(const std::vector<Broken>& files) {
  for (std::size_t i = 0; i < files.size(); ++i) {
    const std::string message =
        message_of([&] { parse_label_image(files[i].bytes, "organ.img"); }, ErrorKind::input);
    EXPECT_TRUE(message.starts_with("organ.img: ")) << message;
    EXPECT_NE(message.find(files[i].says), std::string::npos) << "file " << i << ": " << message;
  }
}

Bytes cut(Bytes bytes, std::size_t length) {
  bytes.resize(length);
  return bytes;
}

Bytes voxels() { return counting<std::uint8_t>(24); }

TEST(ImageMalformed, NiftiHeaders) {
  const double none = std::nan("");
  expect_refused({
      {{}, "ends inside the first four bytes"},
      {{'a', 'b', 'c', 'd', 'e'}, "neither a NIfTI nor an INRIMAGE-4 image"},
      {cut(NiftiFile().bytes(), 200), "ends inside the NIfTI header"},
      {NiftiFile().put<char>(344, 'x').with(voxels()), "mark is missing"},
      {NiftiFile().put<char>(345, 'i').put<char>(344, 'n').with(voxels()), "separate .img file"},
      {NiftiFile().dim(0, 0).with(voxels()), "dim[0]: the number of dimensions is 0"},
      {NiftiFile().dim(0, 8).with(voxels()), "number of dimensions is 8"},
      {NiftiFile().dim(2, 0).with(voxels()), "dim[2]: the size is 0"},
      {NiftiFile().dim(3, -4).with(voxels()), "dim[3]: the size is -4"},
      {NiftiFile().size(4, {2, 3, 4, 5}).with(voxels()), "dim[4]: the image has 5 volumes"},
      {NiftiFile().size(5, {2, 3, 4, 1, 3}).with(voxels()),
       "3 volumes or values per voxel along dimension 5"},
      {NiftiFile().type(128, 24).with(voxels()), "data type 128 is not read"},
      {NiftiFile().type(32, 64).with(voxels()), "data type 32 is not read"},
      {NiftiFile().type(0, 8).with(voxels()), "data type 0 is not read"},
      {NiftiFile().type(2, 16).with(voxels()), "the header says 16"},
      {NiftiFile().real(112, 176, 1).real(116, 184, none).with(voxels()), "scl_inter is nan"},
      {NiftiFile().pixdim(2, 0).with(voxels()), "pixdim[2]: the voxel size is 0"},
      {NiftiFile().pixdim(1, none).with(voxels()), "pixdim[1]: the voxel size is nan"},
      {NiftiFile().pixdim(3, -1).with(voxels()), "pixdim[3]: the voxel size is -1"},
      {NiftiFile().sform({1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0}).with(voxels()),
       "sform: the transform to world coordinates is flat"},
      {NiftiFile().sform({1, 0, 0, none, 0, 1, 0, 0, 0, 0, 1, 0}).with(voxels()), "holds nan"},
      {NiftiFile().sform({1e30, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}).with(voxels()), "which is no position"},
      {NiftiFile().code(252, 344, 1).real(256, 352, none).with(voxels()), "qform: the transform"},
      {NiftiFile().put<float>(108, 100).with(voxels()), "the voxels begin at byte 100"},
      {NiftiFile().put<float>(108, 352.5F).with(voxels()), "begin at byte 352.5"},
      {NiftiFile().put<float>(108, 1e14F).with(voxels()), "after the end of the file"},
      {NiftiFile().put<float>(108, -HUGE_VALF).with(voxels()), "begin at byte -inf"},
      {NiftiFile(2).dim(1, std::int64_t{1} << 62).with(voxels()), "more than the limit of 536870912"},
      {NiftiFile(2).put<std::int64_t>(168, -5).with(voxels()), "begin at byte -5"},
  });
}

TEST(ImageMalformed, NiftiVoxels) {
  Bytes one_too_many = NiftiFile().with(voxels());
  one_too_many.push_back(0);
  const auto value = [](double v) {
    return NiftiFile().size(3, {2, 1, 1}).type(64, 64).with(std::vector{1.0, v});
  };
  expect_refused({
      {cut(NiftiFile().with(voxels()), 375), "can hold at most 23 more bytes"},
      {NiftiFile().size(3, {30000, 30000, 30000}).with(voxels()), "more than the limit"},
      {NiftiFile().size(3, {700, 700, 700}).with(voxels()), "announces 700 x 700 x 700 voxels"},
      {one_too_many, "bytes follow after the last voxel"},
      {value(2.5), "voxel (1, 0, 0): value 2.5 is not a whole number"},
      {value(std::nan("")), "value nan is not a whole number"},
      {value(HUGE_VAL), "value inf is not a whole number"},
      {value(3e9), "label 3e+09 does not fit"},
      {value(1e300), "does not fit"},
      {NiftiFile().size(3, {1, 1, 1}).type(768, 32).with(std::vector<std::uint32_t>{4294967295}),
       "does not fit"},
      {NiftiFile().real(112, 176, 0.3).with(voxels()), "is not a whole number"},
      {NiftiFile().real(112, 176, 1e30).with(voxels()), "does not fit"},
  });
}

TEST(ImageMalformed, Compression) {
  const Bytes good = zipped(NiftiFile().with(voxels()));
  Bytes damaged = good, wrong_sum = good;
  for (std::size_t i = 20; i < 60; ++i) damaged[i] = static_cast<unsigned char>(~damaged[i]);
  wrong_sum[wrong_sum.size() - 6] ^= 1;
  Bytes bomb = zipped(NiftiFile(2).size(3, {800, 800, 800}).with(Bytes(2'000'000)));
  expect_refused({
      {cut(good, 10), "gzip data end too early"},
      {cut(good, good.size() / 2), "end too early"},
      {cut(good, good.size() - 4), "end too early"},
      {damaged, "damaged"},
      {wrong_sum, "damaged"},
      {{0x1F, 0x8B}, "end too early"},
      {{0x1F, 0x8B, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9}, "damaged"},
      {bomb, "the file can hold at most"},
      {zipped(good), "neither a NIfTI"},
  });
}

TEST(ImageMalformed, InrHeadersAndVoxels) {
  const std::string type = "TYPE=unsigned fixed\nPIXSIZE=8 bits\n", size = "XDIM=2\nYDIM=3\nZDIM=4\n";
  const auto file = [](const std::string& lines) { return inr_file(lines, voxels()); };
  Bytes endless = inr_file(size + type, {});
  endless[253] = 'x';
  endless.resize(64 * 256 + 10, '\n');
  expect_refused({
      {cut(file(size + type), 255), "ends inside the INRIMAGE header"},
      {endless, "the end mark ##} of the header is missing"},
      {{'#', 'I', 'N', 'R', 'x'}, "ends inside"},
      {Bytes(300, '#'), "neither"},
      {file(type + "XDIM=2\nYDIM=3\n"), "bytes follow"},
      {file(type + "XDIM=2\nZDIM=3\n"), "'YDIM' is missing"},
      {file(type + size + "XDIM=2\n"), "header line 7: 'XDIM' is given twice"},
      {file(type + "XDIM=2x\nYDIM=3\nZDIM=4\n"), "XDIM: '2x' is not a number"},
      {file(type + "XDIM=-2\nYDIM=3\nZDIM=4\n"), "must be at least 1"},
      {file(type + "XDIM=999999999999999999999\nYDIM=3\nZDIM=4\n"), "is not a number"},
      {file(type + "XDIM=4000000000\nYDIM=4000000000\nZDIM=4000000000\n"), "more than the limit"},
      {file(type + size + "VDIM=3\n"), "3 values per voxel"},
      {file(size + "PIXSIZE=8 bits\n"), "'TYPE' is missing"},
      {file(size + "TYPE=complex\nPIXSIZE=8 bits\n"), "'complex' is not read"},
      {file(size + "TYPE=float\nPIXSIZE=16 bits\nCPU=decm\n"), "a float has 32 or 64 bits"},
      {file(size + "TYPE=unsigned fixed\nPIXSIZE=12 bits\n"), "12 bits per voxel are not read"},
      {file(size + "TYPE=unsigned fixed\nPIXSIZE=16 bits\n"), "'CPU' is missing"},
      {file(size + type + "CPU=vax\n"), "'vax' is not known"},
      {file(size + type + "SCALE=10\n"), "not of the form 2**n"},
      {file(size + type + "SCALE=2**\n"), "not of the form 2**n"},
      {file(size + type + "SCALE=2**-1\n"), "value 0.5 is not a whole number"},
      {file(size + type + "VX=0\n"), "VX: the voxel size is 0"},
      {file(size + type + "VY=nan\n"), "'nan' is not a number"},
      {file(size + type + "RZ=90\n"), "a rotated image is not read"},
      {file(size + type + "what\n"), "'what' is not of the form KEY=value"},
      {cut(file(size + type), 256 + 20), "can hold at most 20 more bytes"},
  });
}

TEST(ImageMalformed, FilesThatCannotBeOpened) {
  EXPECT_NE(message_of([] { read_label_image("/nowhere/a.nii"); }, ErrorKind::input).find("No such file"),
            std::string::npos);
  EXPECT_NE(message_of([] { read_label_image("/tmp"); }, ErrorKind::input).find("directory"),
            std::string::npos);
}

TEST(ImageMalformed, EveryCutAndEveryFlippedByteIsSurvived) {
  const Bytes files[] = {NiftiFile().sform({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}).with(voxels()),
                         zipped(NiftiFile(2, true).with(voxels())),
                         inr_file("XDIM=2\nYDIM=3\nZDIM=4\nTYPE=unsigned fixed\nPIXSIZE=8 bits\n", voxels())};
  const auto survive = [](const Bytes& bytes) {
    try {
      const LabelImage image = parse_label_image(bytes, "a", {1 << 20});
      EXPECT_EQ(image.labels.size(), static_cast<std::size_t>(image.size[0]) *
                                         static_cast<std::size_t>(image.size[1]) *
                                         static_cast<std::size_t>(image.size[2]));
    } catch (const Error&) {
    }
  };
  for (const Bytes& file : files)
    for (std::size_t i = 0; i < file.size(); ++i) {
      survive(cut(file, i));
      for (const unsigned char flip : {0x01, 0x80, 0xFF}) {
        Bytes changed = file;
        changed[i] ^= flip;
        survive(changed);
      }
    }
}

}  // namespace
}  // namespace glisson
