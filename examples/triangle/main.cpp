// A triangle with a colour at each corner, drawn into memory and written as PPM to standard output.
#include <cstdio>

#include <barrido/pipeline/renderer.h>

int main() {
  barrido::raster::Framebuffer frame({.width = 320, .height = 240});
  barrido::pipeline::Renderer renderer(frame);
  renderer.clear({.color = {0.2f, 0.2f, 0.2f, 1.0f}});

  // x and y of the corners; with identity matrices the frame is -1..1 both ways
  const float positions[] = {-0.75f, -0.75f, 0.75f, -0.75f, 0.0f, 0.75f};
  const float colors[] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  barrido::pipeline::Geometry triangle;
  triangle.vertex_count = 3;
  triangle.position = {positions, 2, 2};
  triangle.color = {colors, 3, 3};
  renderer.draw(barrido::pipeline::State{}, triangle);
  renderer.finish();

  std::printf("P6 %d %d 255\n", frame.width(), frame.height());
  for (const std::uint32_t& pixel : frame.color8()) {
    std::fwrite(&pixel, 1, 3, stdout);  // R, G, B in memory order; alpha is left out
  }
}
