#include "viewport/render/finish/FinishTexture.h"

#include "core/asset/finish/FinishNoise.h"
#include "viewport/render/gl/ShaderProgram.h"

#include <epoxy/gl.h>

namespace rubble {

void FinishTexture::bind() {
    const bool isNew = m_texels.id() == 0;
    if (isNew) m_texels = GlTexture::create();
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(TextureUnit::FinishNoise));
    glBindTexture(GL_TEXTURE_3D, m_texels.id());
    if (!isNew) return;
    constexpr GLsizei kSide = FinishNoise::kSide;
    glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA8, kSide, kSide, kSide, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 FinishNoise::shared().texels().data());
    for (const GLenum side : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        glTexParameteri(GL_TEXTURE_3D, side, GL_REPEAT);
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);  // half the samples in software
    glGenerateMipmap(GL_TEXTURE_3D);
}

}  // namespace rubble
