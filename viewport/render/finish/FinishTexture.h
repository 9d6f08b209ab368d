#pragma once

#include "viewport/render/gl/GlObjects.h"

namespace rubble {

/// FinishNoise as a texture.
class FinishTexture {
public:
    /// Binds it; uploads it first if it has not been.
    void bind();

private:
    GlTexture m_texels;
};

}  // namespace rubble
