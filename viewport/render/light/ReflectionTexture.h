#pragma once

#include "viewport/render/gl/GlObjects.h"
#include "viewport/render/light/ReflectionMap.h"

namespace rubble {

/// A reflection map in GPU memory: the texture of sky_light.glsl.
class ReflectionTexture {
public:
    ReflectionTexture();

    void upload(const ReflectionMap& map);
    void bind() const;

private:
    GlTexture m_texels = GlTexture::create();
};

}  // namespace rubble
