#include "viewer/barrido-view/window.h"

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl2.h>
#include <imgui.h>

#include <algorithm>
#include <stdexcept>

namespace barrido::window {
namespace {

Events& events_of(GLFWwindow* window) { return *static_cast<Events*>(glfwGetWindowUserPointer(window)); }

double pixels_per_coordinate(GLFWwindow* window) {
  int window_width = 0, window_height = 0, width = 0, height = 0;
  glfwGetWindowSize(window, &window_width, &window_height);
  glfwGetFramebufferSize(window, &width, &height);
  return window_width > 0 ? static_cast<double>(width) / window_width : 1.0;
}

void key_event(GLFWwindow* window, int key, int, int action, int modifiers) {
  if (action != GLFW_RELEASE) events_of(window).on_key(key, modifiers);
  events_of(window).on_anything();
}

void button_event(GLFWwindow* window, int button, int action, int modifiers) {
  events_of(window).on_button(button, action == GLFW_PRESS, modifiers);
  events_of(window).on_anything();
}

void motion_event(GLFWwindow* window, double x, double y) {
  const double pixels = pixels_per_coordinate(window);
  events_of(window).on_motion(x * pixels, y * pixels);
  events_of(window).on_anything();
}

void wheel_event(GLFWwindow* window, double, double steps) {
  events_of(window).on_wheel(steps);
  events_of(window).on_anything();
}

void drop_event(GLFWwindow* window, int count, const char** paths) {
  events_of(window).on_drop({paths, paths + count});
  events_of(window).on_anything();
}

void set_callbacks(GLFWwindow* window, Events& events) {
  glfwSetWindowUserPointer(window, &events);
  glfwSetKeyCallback(window, key_event);
  glfwSetMouseButtonCallback(window, button_event);
  glfwSetCursorPosCallback(window, motion_event);
  glfwSetScrollCallback(window, wheel_event);
  glfwSetDropCallback(window, drop_event);
  const auto anything = [](GLFWwindow* w) { events_of(w).on_anything(); };
  const auto with_number = [](GLFWwindow* w, int) { events_of(w).on_anything(); };
  const auto with_size = [](GLFWwindow* w, int, int) { events_of(w).on_anything(); };
  glfwSetFramebufferSizeCallback(window, with_size);
  glfwSetWindowRefreshCallback(window, anything);
  glfwSetWindowFocusCallback(window, with_number);
  glfwSetCursorEnterCallback(window, with_number);
}

std::string reason() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text != nullptr ? text : "unknown reason";
}

/// As the desktop says, before there is a window that could be asked.
float screen_scale() {
  float x = 1.0f, y = 1.0f;
  if (GLFWmonitor* monitor = glfwGetPrimaryMonitor()) glfwGetMonitorContentScale(monitor, &x, &y);
  return x;
}

WindowSize fitted(WindowSize wanted) {
  GLFWmonitor* monitor = glfwGetPrimaryMonitor();
  if (monitor == nullptr) return wanted;
  int x = 0, y = 0, width = 0, height = 0;
  glfwGetMonitorWorkarea(monitor, &x, &y, &width, &height);
  if (width <= 0 || height <= 0) return wanted;
  return {std::min(wanted.width, width), std::min(wanted.height, height)};
}

void begin_imgui(GLFWwindow* window, float scale) {
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  ImFontConfig font;
  font.SizePixels = static_cast<float>(static_cast<int>(13.0f * scale));
  io.Fonts->AddFontDefault(&font);
  ImGui::StyleColorsDark();
  ImGui::GetStyle().ScaleAllSizes(scale);
  ImGui_ImplGlfw_InitForOpenGL(window, true);
  ImGui_ImplOpenGL2_Init();
}

}  // namespace

Window::Window(WindowSize picture, float panel_units, float scale, Events& events) {
  if (glfwInit() == GLFW_FALSE) throw std::runtime_error("no window can be opened: " + reason());
  // An old context is all that one quad needs, and is what remote and virtual displays have.
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_FALSE);
  const float letters = std::clamp(scale > 0.0f ? scale : screen_scale(), 0.5f, 4.0f);
  const WindowSize wanted{picture.width + static_cast<int>(panel_units * letters), picture.height};
  const WindowSize fit = fitted(wanted);
  window_ =
      glfwCreateWindow(std::max(fit.width, 64), std::max(fit.height, 64), "barrido-view", nullptr, nullptr);
  if (window_ == nullptr) {
    const std::string why = reason();
    glfwTerminate();
    throw std::runtime_error("no window can be opened: " + why);
  }
  glfwMakeContextCurrent(window_);
  glfwSwapInterval(1);
  // Where the desktop counts in units of several pixels, letters grow with them.
  const float pixels = pixels_per_unit();
  scale_ = scale > 0.0f ? letters : std::max(letters / pixels, 0.5f);
  if (pixels != 1.0f) {
    const auto units = [&](int size) { return static_cast<int>(static_cast<float>(size) / pixels); };
    glfwSetWindowSize(window_, units(wanted.width), units(wanted.height));
  }
  set_callbacks(window_, events);
  begin_imgui(window_, scale_);
}

Window::~Window() {
  ImGui_ImplOpenGL2_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
  glfwDestroyWindow(window_);
  glfwTerminate();
}

WindowSize Window::size() const {
  WindowSize size;
  glfwGetFramebufferSize(window_, &size.width, &size.height);
  return size;
}

float Window::pixels_per_unit() const { return static_cast<float>(pixels_per_coordinate(window_)); }

bool Window::should_close() const { return glfwWindowShouldClose(window_) != 0; }

void Window::set_title(const std::string& title) { glfwSetWindowTitle(window_, title.c_str()); }

void Window::set_clipboard(const std::string& text) { glfwSetClipboardString(window_, text.c_str()); }

double Window::seconds() const { return glfwGetTime(); }

void Window::poll(bool wait) {
  if (wait) {
    glfwWaitEvents();
  } else {
    glfwPollEvents();
  }
}

void Window::poll_for(double seconds) { glfwWaitEventsTimeout(seconds); }

void Window::wake() { glfwPostEmptyEvent(); }

void Window::begin_panel() {
  ImGui_ImplOpenGL2_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
}

void Window::end_panel() {
  ImGui::Render();
  ImGui_ImplOpenGL2_RenderDrawData(ImGui::GetDrawData());
}

void Window::show() { glfwSwapBuffers(window_); }

}  // namespace barrido::window
