#pragma once

#include "core/base/Result.h"

#include <memory>

namespace rubble {

/// An OpenGL context without a display, for rendering to framebuffers. It is current in the thread that created it for
/// its whole lifetime.
class SurfacelessContext {
public:
    /// Errors: Unsupported, with the reason, if EGL offers no OpenGL 3.3.
    static Result<std::unique_ptr<SurfacelessContext>> create();
    ~SurfacelessContext();

private:
    struct State;
    explicit SurfacelessContext(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

}  // namespace rubble
