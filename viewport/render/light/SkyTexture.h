#pragma once

#include "core/base/image/RadianceImage.h"
#include "viewport/render/gl/GlObjects.h"

namespace rubble {

/// The picture of a sky in GPU memory: the texture of sky_file.glsl.
class SkyTexture {
public:
    SkyTexture();

    void upload(const RadianceImage& image);
    void bind() const;

private:
    GlTexture m_texels = GlTexture::create();
};

}  // namespace rubble
