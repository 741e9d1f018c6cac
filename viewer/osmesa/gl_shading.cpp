// Phong and cheap Phong shading as GLSL 1.20, from OpenGL 1.3's equations 2.4 and 2.5 and the two variants of
// cheap Phong. Lights, materials and matrices are read from the fixed-function state.
#include <algorithm>
#include <stdexcept>
#include <string>

#include "viewer/osmesa/gl_map_stages.h"
#include "viewer/osmesa/gl_state.h"
#include "viewer/osmesa/gl_texture_stages.h"

namespace barrido::osmesa {
namespace {

// Definitions that stand before this: LIGHTS, LOCAL_VIEWER, TWO_SIDED, R_DOT_V,
// AMBIENT/DIFFUSE/SPECULAR/EMISSION_TRACKS.
constexpr const char* kCommon = R"(
float attenuation(int i, vec3 position, vec3 to_light, float d) {
  if (gl_LightSource[i].position.w == 0.0) d = 0.0;
  float f = gl_LightSource[i].position.w == 0.0 ? 1.0
          : 1.0 / (gl_LightSource[i].constantAttenuation + gl_LightSource[i].linearAttenuation * d
                   + gl_LightSource[i].quadraticAttenuation * d * d);
  if (gl_LightSource[i].spotCutoff != 180.0) {
    float c = dot(-to_light, normalize(gl_LightSource[i].spotDirection));
    f *= c >= gl_LightSource[i].spotCosCutoff ? pow(max(c, 0.0), gl_LightSource[i].spotExponent) : 0.0;
  }
  return f;
}
vec3 to_light(int i, vec3 position, out float d) {
  vec4 p = gl_LightSource[i].position;
  vec3 v = p.w == 0.0 ? p.xyz : p.xyz / p.w - position;
  d = length(v);
  return v / d;
}
vec3 to_viewer(vec3 position) { return LOCAL_VIEWER ? normalize(-position) : vec3(0.0, 0.0, 1.0); }
float highlight(vec3 n, vec3 l, vec3 v) {
  return R_DOT_V ? dot(2.0 * dot(n, l) * n - l, v) : dot(n, normalize(l + v));
}
float power(float x, float n) { return n == 0.0 ? 1.0 : pow(max(x, 0.0), n); }
gl_MaterialParameters material(bool back) {
  gl_MaterialParameters m = gl_FrontMaterial;
  if (back) m = gl_BackMaterial;
  return m;
}
gl_MaterialParameters tracked(gl_MaterialParameters m, vec4 color) {
  if (AMBIENT_TRACKS) m.ambient = color;
  if (DIFFUSE_TRACKS) m.diffuse = color;
  if (SPECULAR_TRACKS) m.specular = color;
  if (EMISSION_TRACKS) m.emission = color;
  return m;
}
)";

/// Before the texture stages, which read them too.
constexpr const char* kPhongVaryings = "varying vec3 normal; varying vec3 position; varying vec4 color;\n";

constexpr const char* kPhongVertex = R"(
void main() {
  gl_Position = ftransform();
  normal = gl_NormalMatrix * gl_Normal;
  position = vec3(gl_ModelViewMatrix * gl_Vertex);
  color = gl_Color;
  make_tangents();
  make_texture_coordinates(normalize(normal), position);
}
)";

constexpr const char* kPhongFragment = R"(
void main() {
  bool back = TWO_SIDED && !gl_FrontFacing;
  gl_MaterialParameters m = tracked(material(back), color);
  vec3 n = normalize(mapped(normal));
  if (back) n = -n;
  vec3 v = to_viewer(position);
  m.ambient.rgb *= unoccluded();
  vec3 primary = m.emission.rgb + m.ambient.rgb * gl_LightModel.ambient.rgb;
  vec3 secondary = vec3(0.0);
  for (int i = 0; i < LIGHTS; ++i) {
    float d;
    vec3 l = to_light(i, position, d);
    float f = attenuation(i, position, l, d);
    float n_dot_l = dot(n, l);
    primary += f * (m.ambient.rgb * gl_LightSource[i].ambient.rgb
                    + max(n_dot_l, 0.0) * m.diffuse.rgb * gl_LightSource[i].diffuse.rgb);
    if (n_dot_l > 0.0) {
      secondary += f * power(highlight(n, l, v), m.shininess) * m.specular.rgb * gl_LightSource[i].specular.rgb;
    }
  }
  gl_FragColor = finish(vec4(primary, m.diffuse.a), secondary);
}
)";

// The light's weakening f stands in what is interpolated: f N.L, and f^(1/n) h or f h^n.
constexpr const char* kCheapVertex = R"(
varying vec4 color; varying vec4 dots[LIGHTS]; varying vec3 ambient_front; varying vec3 ambient_back;
float second(float n_dot_l, float h, float f, float n) {
  if (POWER_AT_VERTEX || n == 0.0) return n_dot_l > 0.0 ? f * power(h, n) : 0.0;
  return pow(f, 1.0 / n) * h;
}
void main() {
  gl_Position = ftransform();
  color = gl_Color;
  vec3 n = normalize(gl_NormalMatrix * gl_Normal);
  vec3 p = vec3(gl_ModelViewMatrix * gl_Vertex);
  vec3 v = to_viewer(p);
  gl_MaterialParameters front = tracked(material(false), gl_Color);
  gl_MaterialParameters back = tracked(material(true), gl_Color);
  ambient_front = vec3(0.0);
  ambient_back = vec3(0.0);
  for (int i = 0; i < LIGHTS; ++i) {
    float d;
    vec3 l = to_light(i, p, d);
    float f = attenuation(i, p, l, d);
    float n_dot_l = dot(n, l);
    dots[i] = vec4(f * n_dot_l, second(n_dot_l, highlight(n, l, v), f, front.shininess),
                   -f * n_dot_l, second(-n_dot_l, highlight(-n, l, v), f, back.shininess));
    ambient_front += f * front.ambient.rgb * gl_LightSource[i].ambient.rgb;
    ambient_back += f * back.ambient.rgb * gl_LightSource[i].ambient.rgb;
  }
  make_texture_coordinates(n, p);
}
)";

constexpr const char* kCheapFragment = R"(
varying vec4 color; varying vec4 dots[LIGHTS]; varying vec3 ambient_front; varying vec3 ambient_back;
void main() {
  bool back = TWO_SIDED && !gl_FrontFacing;
  gl_MaterialParameters m = tracked(material(back), color);
  vec3 c = m.emission.rgb + unoccluded() * (m.ambient.rgb * gl_LightModel.ambient.rgb
                                            + (back ? ambient_back : ambient_front));
  vec3 secondary = vec3(0.0);
  for (int i = 0; i < LIGHTS; ++i) {
    vec2 at = back ? dots[i].zw : dots[i].xy;
    c += max(at.x, 0.0) * m.diffuse.rgb * gl_LightSource[i].diffuse.rgb;
    float s = at.y;
    if (!POWER_AT_VERTEX && m.shininess != 0.0) s = at.x > 0.0 ? power(at.y, m.shininess) : 0.0;
    secondary += s * m.specular.rgb * gl_LightSource[i].specular.rgb;
  }
  gl_FragColor = finish(vec4(c, m.diffuse.a), secondary);
}
)";

std::string definitions(const pipeline::State& state, bool has_vertex_colors) {
  using pipeline::ColorMaterial;
  const pipeline::Lighting& lighting = state.lighting;
  const ColorMaterial tracks = has_vertex_colors ? lighting.color_material : ColorMaterial::none;
  const bool both = tracks == ColorMaterial::ambient_and_diffuse;
  std::string text = "#version 120\n";
  const auto define = [&text](const std::string& name, bool value) {
    text += "#define " + name + (value ? " true\n" : " false\n");
  };
  text += "#define LIGHTS " + std::to_string(std::min(lighting.lights.size(), kGlLights)) + "\n";
  define("LOCAL_VIEWER", lighting.local_viewer);
  define("TWO_SIDED", lighting.two_sided);
  define("R_DOT_V", lighting.specular_model == pipeline::SpecularModel::phong);
  define("POWER_AT_VERTEX", state.cheap_phong_power == pipeline::CheapPhongPower::vertex);
  define("AMBIENT_TRACKS", both || tracks == ColorMaterial::ambient);
  define("DIFFUSE_TRACKS", both || tracks == ColorMaterial::diffuse);
  define("SPECULAR_TRACKS", tracks == ColorMaterial::specular);
  define("EMISSION_TRACKS", tracks == ColorMaterial::emission);
  return text + kCommon;
}

void attach(GLuint program, GLenum stage, const std::string& source) {
  const GLuint shader = gl().CreateShader(stage);
  const char* text = source.c_str();
  gl().ShaderSource(shader, 1, &text, nullptr);
  gl().CompileShader(shader);
  gl().AttachShader(program, shader);
  GLint compiled = 0;
  gl().GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (compiled == 0) {
    char log[2048] = "";
    gl().GetShaderInfoLog(shader, sizeof log, nullptr, log);
    throw std::runtime_error(std::string("a reference shader does not compile: ") + log);
  }
  gl().DeleteShader(shader);
}

/// What the text of a draw's program depends on.
std::string program_key(const pipeline::State& state, bool has_colors) {
  const pipeline::Lighting& lighting = state.lighting;
  std::string key;
  for (const int part :
       {static_cast<int>(state.shade_model), static_cast<int>(lighting.lights.size()),
        static_cast<int>(lighting.local_viewer), static_cast<int>(lighting.two_sided),
        static_cast<int>(lighting.specular_model), static_cast<int>(lighting.separate_specular),
        static_cast<int>(state.cheap_phong_power),
        has_colors ? static_cast<int>(lighting.color_material) : 0}) {
    key += std::to_string(part) + ' ';
  }
  return key + vertex_texture_stages(state) + fragment_texture_stages(state) + vertex_map_stages(state) +
         fragment_map_stages(state);
}

GLuint make_program(const pipeline::State& state, bool has_vertex_colors) {
  const bool phong = !pipeline::shading_mode(state.shade_model).lit.at_vertices;
  const std::string head = definitions(state, has_vertex_colors) + (phong ? kPhongVaryings : "");
  const GLuint program = gl().CreateProgram();
  attach(
      program, GL_VERTEX_SHADER,
      head + vertex_texture_stages(state) + vertex_map_stages(state) + (phong ? kPhongVertex : kCheapVertex));
  attach(program, GL_FRAGMENT_SHADER,
         head + fragment_texture_stages(state) + fragment_map_stages(state) +
             (phong ? kPhongFragment : kCheapFragment));
  gl().LinkProgram(program);
  GLint linked = 0;
  gl().GetProgramiv(program, GL_LINK_STATUS, &linked);
  if (linked == 0) throw std::runtime_error("a reference program does not link");
  gl().UseProgram(program);
  set_samplers(program, state);
  gl().UseProgram(0);
  return program;
}

}  // namespace

Programs::~Programs() {
  for (const auto& [key, program] : programs_) gl().DeleteProgram(program);
}

GLuint Programs::program_of(const pipeline::State& state, bool has_vertex_colors) {
  if (!state.lighting.enabled || !pipeline::shading_mode(state.shade_model).lit.at_fragments) return 0;
  const auto [slot, is_new] = programs_.try_emplace(program_key(state, has_vertex_colors), 0);
  if (is_new) slot->second = make_program(state, has_vertex_colors);
  return slot->second;
}

}  // namespace barrido::osmesa
