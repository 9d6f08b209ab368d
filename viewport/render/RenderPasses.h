#pragma once

#include "viewport/render/AxesIndicator.h"
#include "viewport/render/FrameBlock.h"
#include "viewport/render/LightBuffer.h"
#include "viewport/render/OutlinePass.h"
#include "viewport/render/RenderPrograms.h"
#include "viewport/render/SceneBuffers.h"
#include "viewport/render/SkyMaps.h"
#include "viewport/render/TransparencyPass.h"
#include "viewport/render/finish/FinishTexture.h"
#include "viewport/render/gl/InstanceBuffer.h"
#include "viewport/render/gl/RenderTarget.h"
#include "viewport/render/light/ReflectionTexture.h"
#include "viewport/render/light/SkyTexture.h"

namespace rubble {

// Texels of shadow maps on each side: about 5 mm, 9 mm and 4 cm for a house.
inline constexpr int kKeyWidth = 2048, kSmallKeyWidth = 1024, kSkyWidth = 256;

struct EdgePass;

/// The passes that make up an image; they draw to the bound framebuffer.
struct RenderPasses {
    RenderPasses(RenderPrograms made, OutlinePass outlinePass, TransparencyPass transparencyPass)
        : programs(std::move(made)), outlines(std::move(outlinePass)), transparency(std::move(transparencyPass)) {}

    void setScene(std::shared_ptr<const RenderScene> made);
    void setFrame(const FrameBlock& block);
    /// Computes the light of the sky where it differs from that of the last image.
    void setSky(const RenderSettings& settings);
    /// Begins an image: sets its frame and renders its shadow maps. For one by itself, they stay as long as the scene.
    void setShadows(const RenderView& view, const LightSample& sample, bool isSingle);
    /// Shadow maps may be incomplete: those of the next image are rendered anew.
    void invalidateShadows();
    /// Fills the light buffer for it.
    void setLight(const RenderView& view);
    void drawImage(const RenderView& view);
    const ShaderProgram& lit(const LitPrograms& variants) const;
    void drawSolid(ImageSize size);
    void drawTransparent(const RenderView& view);
    void drawDepths(std::uint32_t surfaces);
    void drawWireframe(const RenderView& view);
    void drawHulls(const RenderView& view);
    void drawEdges(const EdgePass& pass);
    void drawGround(const RenderView& view);
    void drawSceneLines();
    void drawOverDepths(const RenderView& view, const ShaderProgram& program, const InstanceBuffer& instances);
    void drawMarks();
    void drawChips();
    void drawOutlines(const RenderView& view);
    void drawAxes(const RenderView& view);
    void drawScreenLines(const std::vector<ScreenLine>& lines);
    void drawFullscreen() const;
    void drawScaled(const RenderTarget& source, float weight) const;

    RenderPrograms programs;
    OutlinePass outlines;
    TransparencyPass transparency;
    SceneBuffers scene;
    FinishTexture finishTexture;
    InstanceBuffer sceneLines{4, 4, 4, 4};
    InstanceBuffer sceneBoxes{4, 4, 4, 4};
    InstanceBuffer particles{4, 4, 4};
    InstanceBuffer chips{4, 4, 4, 4};
    InstanceBuffer decals{4, 4, 4};
    DepthCopy solidDepths;
    SceneSummary summary;  // of `scene`
    /// Shadow maps of an image by itself, which stay as long as its scene does, and of one of many, or of one at a low
    /// resolution.
    ShadowMap singleKey{kKeyWidth}, smallKey{kSmallKeyWidth};
    SkyMaps singleSky{kSkyWidth}, sampledSky{kSkyWidth};
    /// What a shadow map of the key light holds for an image by itself.
    struct KeyContent {
        ShadowMap* map = nullptr;
        double stepFraction = 1.0;
        LightRegion region;
        Vec3 direction{0.0};
        bool operator==(const KeyContent&) const = default;
    };
    KeyContent keyContent;
    double skyStepFraction = 1.0;  // of singleSky
    ShadowMap* key = &singleKey;   // of the image, as the next
    SkyMaps* sky = &singleSky;
    LightBuffer lightBuffer;
    SkyLight skyLight;
    ReflectionTexture reflections;
    SkyTexture skyTexture;
    bool hasShadows = false;
    FrameBlock frame{};
    GlBuffer frameUniforms = GlBuffer::create();
    GlVertexArray emptyArray = GlVertexArray::create();  // for draws without vertex attributes
    GlVertexArray lineArray = GlVertexArray::create();
    GlBuffer lineBuffer = GlBuffer::create();
};

}  // namespace rubble
