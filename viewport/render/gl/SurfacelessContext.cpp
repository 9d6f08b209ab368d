#include "viewport/render/gl/SurfacelessContext.h"

#include "core/base/OutOfMemory.h"
#include "core/base/Parallel.h"
#include "core/base/limits/SoftwareRendererNeeds.h"

#include <dlfcn.h>
#include <epoxy/egl.h>

namespace rubble {

struct SurfacelessContext::State {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;
    ~State() {
        if (display == EGL_NO_DISPLAY) return;
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
        eglReleaseThread();
    }
};

namespace {

Error noContext(const std::string& reason) {
    return {ErrorCode::Unsupported, "This machine has no OpenGL 3.3 to render images with: " + reason + "."};
}

/// EGL's only display without a screen. It is never terminated: that would end the contexts of other threads.
Result<EGLDisplay> initializedDisplay() {
    // Check both first: without them, Mesa hangs or crashes.
    if (!areRendererThreadsLeft(availableProcessors())) return outOfThreads("rendering images");
    if (!isRendererMemoryLeft()) return outOfMemory("rendering images");
    // Check first: epoxy aborts the program if the library or a function is missing.
    if (dlopen("libEGL.so.1", RTLD_LAZY) == nullptr) return noContext("libEGL.so.1 is not installed");
    if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless") ||
        !epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_base")) {
        return noContext("EGL does not support rendering without a display");
    }
    const EGLDisplay display = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) == EGL_FALSE)
        return noContext("EGL finds no graphics driver");
    return display;
}

}  // namespace

Result<std::unique_ptr<SurfacelessContext>> SurfacelessContext::create() {
    static const Result<EGLDisplay> display = initializedDisplay();
    if (!display) return display.error();
    auto state = std::make_unique<State>();
    state->display = *display;
    if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE) return noContext("EGL offers OpenGL ES only");
    constexpr EGLint kAttributes[] = {
        EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    state->context = eglCreateContext(state->display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, kAttributes);
    if (state->context == EGL_NO_CONTEXT) return noContext("the graphics driver is too old");
    if (eglMakeCurrent(state->display, EGL_NO_SURFACE, EGL_NO_SURFACE, state->context) == EGL_FALSE) {
        return noContext("EGL does not support rendering without a display");
    }
    return std::unique_ptr<SurfacelessContext>(new SurfacelessContext(std::move(state)));
}

SurfacelessContext::SurfacelessContext(std::unique_ptr<State> state) : m_state(std::move(state)) {}
SurfacelessContext::~SurfacelessContext() = default;

}  // namespace rubble
