#pragma once

#include "core/base/image/EncodedImage.h"
#include "viewport/render/ImageDecoding.h"
#include "viewport/render/gl/GlObjects.h"

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <utility>
#include <vector>

namespace rubble {

using SharedImage = std::shared_ptr<const EncodedImage>;

/// The longest side in pixels, a power of two, that makes images fit into `bytes` of texture memory, with mipmaps.
std::uint32_t longestSide(const std::vector<SharedImage>& images, std::size_t bytes);

/// The images of a scene as textures. Another thread decodes each once, in a size that lets all fit into memory. Until
/// it is decoded, what has it is drawn without.
class SceneTextures {
public:
    SceneTextures() = default;
    ~SceneTextures();
    SceneTextures(const SceneTextures&) = delete;
    SceneTextures& operator=(const SceneTextures&) = delete;

    /// A function that the decoding thread calls after each image. Without one, setImages() waits for all.
    void setListener(std::function<void()> listener) { m_listener = std::move(listener); }
    /// Begins to decode the images of a scene that the previous one did not have, and drops those that it has not.
    void setImages(std::vector<SharedImage> images);
    /// Uploads what has been decoded since; whether that was something.
    bool update();
    /// Whether images are still to be decoded.
    bool isPending() const;
    bool isEmpty() const { return m_textures.empty(); }
    /// The name of the texture; 0 if the image is not decoded yet, or cannot be.
    std::uint32_t textureOf(const SharedImage& image) const;

private:
    void run(const std::stop_token& stop);
    void waitForAll();

    std::function<void()> m_listener;
    std::map<SharedImage, GlTexture> m_textures;  // no texture: it cannot be decoded
    std::vector<SharedImage> m_images;            // of the scene
    std::uint32_t m_longest = 0;

    mutable std::mutex m_mutex;
    std::condition_variable_any m_changed;
    std::vector<SharedImage> m_waiting;  // the next one last
    std::vector<std::pair<SharedImage, std::optional<DecodedImage>>> m_decoded;
    SharedImage m_decoding;  // null: none
    std::jthread m_thread;   // begins with the first image
};

}  // namespace rubble
