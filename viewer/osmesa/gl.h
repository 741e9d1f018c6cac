// OpenGL as OSMesa has it: the functions are looked up in the library when they are first needed, by name, so
// that nothing links it, and a program that shows its window with another OpenGL keeps the two apart.
#pragma once

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

// It would leave out the functions after OpenGL 1.3.
#include <GL/osmesa.h>

namespace barrido::osmesa {

// clang-format off
#define BARRIDO_GL_FUNCTIONS(F) \
  F(ActiveTexture) F(AlphaFunc) F(AttachShader) F(BindFramebuffer) F(BindRenderbuffer) F(BindTexture) F(BlendColor) \
  F(BlendEquation) F(BlendFuncSeparate) F(CallList) F(CheckFramebufferStatus) F(Clear) F(ClearColor) F(ClearDepth) \
  F(ClientActiveTexture) F(ClipPlane) F(Color4f) F(ColorMask) F(ColorMaterial) F(ColorPointer) F(CompileShader) \
  F(CreateProgram) F(CreateShader) F(CullFace) F(DeleteFramebuffers) F(DeleteProgram) F(DeleteRenderbuffers) \
  F(DeleteShader) F(DeleteTextures) F(DepthFunc) F(DepthMask) F(DepthRange) F(Disable) F(DisableClientState) \
  F(DrawArrays) F(DrawElements) F(Enable) F(EnableClientState) F(EndList) F(Finish) F(Fogf) F(Fogfv) F(Fogi) \
  F(FramebufferRenderbuffer) F(FrontFace) F(GenFramebuffers) F(GenLists) F(GenRenderbuffers) F(GenTextures) \
  F(GetError) F(GetProgramiv) F(GetShaderInfoLog) F(GetShaderiv) F(GetString) F(GetUniformLocation) F(Hint) \
  F(LightModelfv) F(LightModeli) F(Lightf) F(Lightfv) F(LineWidth) F(LinkProgram) F(LoadIdentity) F(LoadMatrixf) \
  F(Materialf) F(Materialfv) F(MatrixMode) F(MultiTexCoord4fv) F(NewList) F(Normal3f) F(NormalPointer) F(PixelStorei) \
  F(PointSize) F(PolygonMode) F(PolygonOffset) F(PopAttrib) F(PopClientAttrib) F(PopMatrix) F(PushAttrib) \
  F(PushClientAttrib) F(PushMatrix) F(ReadPixels) F(RenderbufferStorage) F(Scissor) F(ShadeModel) F(ShaderSource) \
  F(TexCoordPointer) F(TexEnvf) F(TexEnvfv) F(TexEnvi) F(TexGenfv) F(TexGeni) F(TexImage2D) F(TexParameterfv) \
  F(TexParameteri) F(Uniform1i) F(UseProgram) F(VertexPointer) F(Viewport)
// clang-format on

/// OpenGL's functions without their "gl", and OSMesa's own.
struct Gl {
#define BARRIDO_GL_MEMBER(name) decltype(&::gl##name) name = nullptr;
  BARRIDO_GL_FUNCTIONS(BARRIDO_GL_MEMBER)
#undef BARRIDO_GL_MEMBER
  decltype(&::OSMesaCreateContextAttribs) create_context = nullptr;
  decltype(&::OSMesaDestroyContext) destroy_context = nullptr;
  decltype(&::OSMesaMakeCurrent) make_current = nullptr;
};

/// @throws std::runtime_error when OSMesa cannot be loaded, with the reason.
const Gl& gl();

/// @throws std::runtime_error when an OpenGL error has happened; `where` says after what.
void check_error(const char* where);

}  // namespace barrido::osmesa
