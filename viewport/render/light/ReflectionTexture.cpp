#include "viewport/render/light/ReflectionTexture.h"

#include "viewport/render/gl/ShaderProgram.h"

#include <epoxy/gl.h>

namespace rubble {

ReflectionTexture::ReflectionTexture() {
    bind();
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        glTexParameteri(GL_TEXTURE_3D, filter, GL_LINEAR);
    for (const GLenum side : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        glTexParameteri(GL_TEXTURE_3D, side, GL_CLAMP_TO_EDGE);
}

void ReflectionTexture::upload(const ReflectionMap& map) {
    bind();
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA16F, ReflectionMap::kStored, ReflectionMap::kStored, ReflectionMap::kLevels,
                 0, GL_RGB, GL_FLOAT, map.texels.data());
}

void ReflectionTexture::bind() const {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(TextureUnit::Reflections));
    glBindTexture(GL_TEXTURE_3D, m_texels.id());
}

}  // namespace rubble
