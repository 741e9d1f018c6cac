// Standard output as the place of the picture, pipes that close, progress on a terminal, and what is mapped
// into the process while it draws.
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <optional>

#include <gtest/gtest.h>

#include "pipeline/pictures/image_io.h"
#include "tests/unit/viewer/program.h"
#include "tests/unit/viewer/tiny_models.h"
#include "viewer/barrido/standard_streams.h"

namespace barrido::test {
namespace {

using Words = std::vector<std::string>;

class RenderStreams : public ::testing::Test {
 protected:
  RenderStreams() { write_textured_glb(folder_.path() / "bumps.glb", 8); }
  TemporaryFolder folder_;
};

std::string read_to_end(int descriptor) {
  std::string text;
  std::array<char, 65536> buffer{};
  for (ssize_t count = 0; (count = read(descriptor, buffer.data(), buffer.size())) > 0;) {
    text.append(buffer.data(), static_cast<std::size_t>(count));
  }
  return text;
}

TEST_F(RenderStreams, ThePictureOnStandardOutputIsThePictureInAFile) {
  const Outcome outcome = run({"render", "bumps.glb", "-o", "-", "--hash", "--resolution", "64,48"},
                              {folder_.path(), "", false, 0});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(
      run({"render", "bumps.glb", "-o", "a.png", "--resolution", "64,48"}, {folder_.path(), "", false, 0})
          .status,
      0);
  EXPECT_EQ(outcome.out, read_text(folder_.path() / "a.png"));
  EXPECT_EQ(outcome.error.substr(64), "  bumps/phong\n") << "the text goes where the picture does not";
}

TEST_F(RenderStreams, ASheetOnStandardOutput) {
  const Outcome outcome =
      run({"render", "bumps.glb", "-o", "-", "--sheet", "--shading", "all", "--resolution", "64,48"},
          {folder_.path(), "", false, 0});
  EXPECT_EQ(outcome.status, 0) << outcome.error;
  const scene::Image sheet = scene::decode_image(cli::bytes_of(outcome.out), "sheet");
  EXPECT_GT(sheet.width * sheet.height, 4 * 64 * 48);
}

/// A frame of noise is far larger than a pipe holds, so the program waits in the middle of writing it, with
/// everything loaded that it needed from the model to the PNG.
TEST_F(RenderStreams, NoWindowSystemIsMappedWhileAGlbBecomesAPng) {
  const Running running = start({"render", "bumps.glb", "-o", "-", "--compression", "0"}, folder_.path());
  pollfd readable{running.output, POLLIN, 0};
  ASSERT_EQ(poll(&readable, 1, 60'000), 1);
  const std::string maps = read_text("/proc/" + std::to_string(running.process) + "/maps");
  const std::string picture = read_to_end(running.output);
  close(running.output);
  EXPECT_EQ(wait_for(running.process), 0);
  ASSERT_GT(picture.size(), 1u << 20) << "the program may have ended before it was looked at";
  ASSERT_NE(maps.find("libtbb"), std::string::npos) << "this is not the program's map";
  for (const char* library :
       {"libGL", "libEGL", "libX11", "libxcb", "libwayland", "libglfw", "libOpenImageIO", "libOSMesa",
        "libopencv", "libwebp", "libgif", "libdraco", "libmeshoptimizer", "barrido_"}) {
    EXPECT_EQ(maps.find(library), std::string::npos) << library;
  }
}

TEST_F(RenderStreams, AModelFromStandardInput) {
  RunOptions options{folder_.path(), "", false, 0, (folder_.path() / "bumps.glb").string()};
  const Words size{"--resolution", "64,48", "--hash"};
  const auto hash_of = [&](Words words) {
    words.insert(words.end(), size.begin(), size.end());
    const Outcome outcome = run(words, options);
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    return outcome.out.substr(0, outcome.out.find(' '));
  };
  EXPECT_EQ(hash_of({"render", "-"}), hash_of({"render", "bumps.glb"}));
  EXPECT_EQ(run({"render", "-", "-o", "{model}.png", "--resolution", "64,48"}, options).status, 0);
  EXPECT_NE(read_text(folder_.path() / "stdin.png"), "");
  EXPECT_EQ(run({"info", "-"}, options).status, 0);
  EXPECT_EQ(run({"inspect", "-", "--pixel", "3,4"}, options).status, 0);
  const Outcome twice = run({"render", "-", "-", "--hash"}, options);
  EXPECT_EQ(twice.status, 2);
  EXPECT_EQ(lines_of(twice.error)[0], "barrido: render: standard input, -, can be read only once");
  EXPECT_EQ(run({"info", "--validate", "-"}, options).status, 2);
}

TEST_F(RenderStreams, ModelsFromStandardInputNameNoFiles) {
  write_text(
      folder_.path() / "outside.gltf",
      R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
      R"("buffers":[{"uri":"bumps.glb","byteLength":36}],"bufferViews":[{"buffer":0,"byteLength":36}],)"
      R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],)"
      R"("max":[1,1,1]}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}]})");
  RunOptions options{folder_.path(), "", false, 0, (folder_.path() / "outside.gltf").string()};
  const Outcome outside = run({"render", "-", "--hash"}, options);
  EXPECT_EQ(outside.status, 2);
  EXPECT_EQ(outside.error,
            "barrido: <stdin>: buffers[0] (bumps.glb): a model from standard input has no folder to read it "
            "from\n");
  options.in_path = "/dev/null";
  const Outcome nothing = run({"render", "-", "--hash"}, options);
  EXPECT_EQ(nothing.status, 2);
  EXPECT_EQ(nothing.error.rfind("barrido: <stdin>: ", 0), 0u) << nothing.error;
}

TEST_F(RenderStreams, BarePixelsAreThoseOfThePictures) {
  const Outcome raw =
      run({"render", "bumps.glb", "-o", "-", "--raw", "--turntable", "3", "--resolution", "64,48"},
          {folder_.path(), "", false, 0});
  EXPECT_EQ(raw.status, 0) << raw.error;
  ASSERT_EQ(raw.out.size(), 3u * 64 * 48 * 4);
  EXPECT_EQ(run({"render", "bumps.glb", "-o", "f{frame}.png", "--turntable", "3", "--resolution", "64,48"},
                {folder_.path(), "", false, 0})
                .status,
            0);
  for (std::size_t n = 0; n < 3; ++n) {
    const scene::Image image = scene::read_image(folder_.path() / ("f" + std::to_string(n) + ".png"));
    const std::string pixels(reinterpret_cast<const char*>(image.rgba.data()), image.rgba.size());
    EXPECT_TRUE(pixels == raw.out.substr(n * pixels.size(), pixels.size())) << n;
  }
  EXPECT_EQ(run({"render", "bumps.glb", "-o", "a.png", "--raw"}, {folder_.path(), "", false, 0}).status, 2);
}

TEST_F(RenderStreams, AReaderThatLeavesIsAnError) {
  std::array<int, 2> error_ends{};
  ASSERT_EQ(pipe(error_ends.data()), 0);
  const int saved_error = dup(STDERR_FILENO);
  dup2(error_ends[1], STDERR_FILENO);
  const Running running = start({"render", "bumps.glb", "-o", "-", "--compression", "0"}, folder_.path());
  dup2(saved_error, STDERR_FILENO);
  close(saved_error);
  close(error_ends[1]);
  char first = 0;
  EXPECT_EQ(read(running.output, &first, 1), 1);
  close(running.output);
  EXPECT_EQ(wait_for(running.process), 2);
  EXPECT_EQ(read_to_end(error_ends[0]), "barrido: standard output: Broken pipe\n");
  close(error_ends[0]);
}

TEST_F(RenderStreams, FullAndClosedStandardOutputsAreErrors) {
  const Words words{"render", "bumps.glb", "-o", "-", "--resolution", "64,48"};
  const Outcome full = run(words, {folder_.path(), "/dev/full", false, 0});
  EXPECT_EQ(full.status, 2);
  EXPECT_EQ(full.error, "barrido: standard output: No space left on device\n");
  const Outcome closed = run(words, {folder_.path(), "", true, 0});
  EXPECT_EQ(closed.status, 2);
  EXPECT_EQ(closed.error, "barrido: standard output: Bad file descriptor\n");
}

TEST_F(RenderStreams, HashesIntoAClosedPipeAreErrors) {
  const Outcome full = run({"render", "bumps.glb", "--hash", "--resolution", "64,48"},
                           {folder_.path(), "/dev/full", false, 0});
  EXPECT_EQ(full.status, 2);
  EXPECT_EQ(full.error, "barrido: standard output: No space left on device\n");
}

/// Starts the program with standard error on a pseudo terminal and reads from there until `text` is seen.
/// @return what was shown, also when it takes longer than half a minute; nothing where there are no pseudo
/// terminals.
std::optional<std::string> shown_until(const std::string& text, const Words& words,
                                       const std::filesystem::path& folder) {
  const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
  if (terminal < 0 || grantpt(terminal) != 0 || unlockpt(terminal) != 0) return std::nullopt;
  const int slave = open(ptsname(terminal), O_RDWR | O_NOCTTY);
  const int saved_error = dup(STDERR_FILENO);
  dup2(slave, STDERR_FILENO);
  const Running running = start(words, folder);
  dup2(saved_error, STDERR_FILENO);
  close(saved_error);
  close(slave);
  std::string shown;
  std::array<char, 1024> buffer{};
  pollfd readable{terminal, POLLIN, 0};
  while (shown.find(text) == std::string::npos && poll(&readable, 1, 30'000) == 1) {
    const ssize_t count = read(terminal, buffer.data(), buffer.size());
    if (count <= 0) break;
    shown.append(buffer.data(), static_cast<std::size_t>(count));
  }
  kill(running.process, SIGKILL);
  wait_for(running.process);
  close(running.output);
  close(terminal);
  return shown;
}

TEST_F(RenderStreams, ProgressIsSeenOnATerminal) {
  const auto begin = std::chrono::steady_clock::now();
  const auto shown = shown_until(
      "of 100000)", {"render", "bumps.glb", "--hash", "--turntable", "100000", "--resolution", "256,256"},
      folder_.path());
  if (!shown) GTEST_SKIP() << "no pseudo terminals here";
  // Where loading takes a second, that is shown first.
  EXPECT_EQ(shown->find("\r\x1b[K"), 0u) << *shown;
  EXPECT_NE(shown->find("\r\x1b[Kdrawing bumps/phong/frame"), std::string::npos) << *shown;
  EXPECT_GE(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(990));
}

}  // namespace
}  // namespace barrido::test
