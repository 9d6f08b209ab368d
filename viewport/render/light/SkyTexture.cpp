#include "viewport/render/light/SkyTexture.h"

#include "viewport/render/gl/ShaderProgram.h"

#include <epoxy/gl.h>

namespace rubble {

SkyTexture::SkyTexture() {
    bind();
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        glTexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

void SkyTexture::upload(const RadianceImage& image) {
    bind();
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB16F, static_cast<GLsizei>(image.width), static_cast<GLsizei>(image.height), 0,
                 GL_RGB, GL_FLOAT, image.pixels.data());
}

void SkyTexture::bind() const {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(TextureUnit::SkyFile));
    glBindTexture(GL_TEXTURE_2D, m_texels.id());
}

}  // namespace rubble
