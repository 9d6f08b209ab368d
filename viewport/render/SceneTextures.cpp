#include "viewport/render/SceneTextures.h"

#include "viewport/render/gl/ShaderProgram.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <new>
#include <utility>

namespace rubble {
namespace {

constexpr std::size_t kMaxBytes = std::size_t{320} << 20;  // of textures: 50 of 4096 × 4096 are drawn in 1024 × 1024
constexpr std::uint32_t kLongestSide = 4096, kShortestSide = 64;

/// An image that repeats, with all of its mipmaps.
GlTexture textureWith(const DecodedImage& image) {
    GlTexture texture = GlTexture::create();
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(TextureUnit::BaseColour));
    glBindTexture(GL_TEXTURE_2D, texture.id());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8, static_cast<GLsizei>(image.width), static_cast<GLsizei>(image.height), 0,
                 GL_RGB, GL_UNSIGNED_BYTE, image.pixels.data());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_REPEAT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glGenerateMipmap(GL_TEXTURE_2D);
    return texture;
}

/// Without memory, it is drawn without the image.
std::optional<DecodedImage> decodedOrNothing(const EncodedImage& image, std::uint32_t longest) {
    try {
        return decoded(image, longest);
    } catch (const std::bad_alloc&) {
        return std::nullopt;
    }
}

std::uint32_t supportedSide() {
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    return std::min(kLongestSide, static_cast<std::uint32_t>(largest));
}

}  // namespace

std::uint32_t longestSide(const std::vector<SharedImage>& images, std::size_t bytes) {
    for (std::uint32_t longest = kLongestSide; longest > kShortestSide; longest /= 2) {
        std::size_t needed = 0;
        for (const SharedImage& image : images) {
            std::uint32_t factor = 1;
            while (std::max(image->width(), image->height()) / factor > longest) factor *= 2;
            needed += std::size_t{16} * (image->width() / factor) * (image->height() / factor) / 3;
        }
        if (needed <= bytes) return longest;
    }
    return kShortestSide;
}

SceneTextures::~SceneTextures() {
    m_thread.request_stop();
    m_changed.notify_all();
}

void SceneTextures::setImages(std::vector<SharedImage> images) {
    update();
    std::ranges::sort(images);
    images.erase(std::ranges::unique(images).begin(), images.end());
    const std::uint32_t longest = std::min(longestSide(images, kMaxBytes), supportedSide());
    if (images == m_images && longest == m_longest) return;
    std::erase_if(m_textures, [&](const auto& texture) {
        return longest != m_longest || !std::ranges::binary_search(images, texture.first);
    });
    m_images = std::move(images);
    {
        const std::lock_guard lock(m_mutex);
        if (longest != m_longest) m_decoded.clear();
        m_longest = longest;
        m_waiting.clear();
        for (const SharedImage& image : m_images) {
            const bool isDecoded =
                std::ranges::find(m_decoded, image, [](const auto& one) { return one.first; }) != m_decoded.end();
            if (!m_textures.contains(image) && image != m_decoding && !isDecoded) m_waiting.push_back(image);
        }
        if (m_waiting.empty() && m_decoding == nullptr) return;
        if (!m_thread.joinable()) m_thread = std::jthread([this](const std::stop_token& stop) { run(stop); });
    }
    m_changed.notify_all();
    if (!m_listener) waitForAll();
}

void SceneTextures::waitForAll() {
    std::unique_lock lock(m_mutex);
    m_changed.wait(lock, [&] { return m_waiting.empty() && m_decoding == nullptr; });
    lock.unlock();
    update();
}

bool SceneTextures::update() {
    std::unique_lock lock(m_mutex);
    const auto decoded = std::exchange(m_decoded, {});
    lock.unlock();
    bool isNew = false;
    for (const auto& [source, image] : decoded) {
        if (!std::ranges::binary_search(m_images, source)) continue;
        m_textures[source] = image ? textureWith(*image) : GlTexture();
        isNew = true;
    }
    return isNew;
}

bool SceneTextures::isPending() const {
    const std::lock_guard lock(m_mutex);
    return !m_waiting.empty() || m_decoding != nullptr || !m_decoded.empty();
}

std::uint32_t SceneTextures::textureOf(const SharedImage& image) const {
    const auto found = m_textures.find(image);
    return found != m_textures.end() ? found->second.id() : 0;
}

void SceneTextures::run(const std::stop_token& stop) {
    std::unique_lock lock(m_mutex);
    while (m_changed.wait(lock, stop, [&] { return !m_waiting.empty(); })) {
        const SharedImage source = m_waiting.back();
        const std::uint32_t longest = m_longest;
        m_waiting.pop_back();
        m_decoding = source;
        lock.unlock();
        std::optional<DecodedImage> image = decodedOrNothing(*source, longest);
        lock.lock();
        m_decoding = nullptr;
        if (longest == m_longest)
            m_decoded.emplace_back(source, std::move(image));
        else
            m_waiting.push_back(source);  // the sizes have changed
        m_changed.notify_all();
        if (!m_listener) continue;
        lock.unlock();
        m_listener();
        lock.lock();
    }
}

}  // namespace rubble
