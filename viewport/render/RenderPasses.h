#pragma once

#include "viewport/render/AxesIndicator.h"
#include "viewport/render/FrameBlock.h"
#include "viewport/render/InstanceBuffer.h"
#include "viewport/render/OutlinePass.h"
#include "viewport/render/RenderPrograms.h"
#include "viewport/render/RenderTarget.h"
#include "viewport/render/SceneBuffers.h"
#include "viewport/render/ShadowMap.h"
#include "viewport/render/TransparencyPass.h"

#include <optional>

namespace rubble {

/// A rectangle of an image, pixels from the lower left corner.
struct PixelBox {
    int x = 0, y = 0, width = 0, height = 0;
    bool contains(int px, int py) const { return px >= x && py >= y && px < x + width && py < y + height; }
};

inline constexpr int kShadowWidth = 2048;    // texels: about 5 mm for a house
inline constexpr int kSkyShadowWidth = 512;  // soft anyway: the mean over the whole sky

struct EdgePass;

/// The passes that make up an image; they draw to the bound framebuffer.
struct RenderPasses {
    RenderPasses(RenderPrograms made, OutlinePass outlinePass, TransparencyPass transparencyPass)
        : programs(std::move(made)), outlines(std::move(outlinePass)), transparency(std::move(transparencyPass)) {}

    void setScene(std::shared_ptr<const RenderScene> made);
    void setFrame(const FrameBlock& block);
    void drawShadows(const RenderView& view, const std::optional<LightSample>& lightSample);
    void drawImage(const RenderView& view);
    const ShaderProgram& lit(const LitPrograms& variants) const;
    void drawBackground();
    void drawSolid();
    void drawTransparent(const RenderView& view);
    void drawWireframe(const RenderView& view);
    void drawHulls(const RenderView& view);
    void drawEdges(const EdgePass& pass);
    void drawGround(const RenderView& view);
    void drawSceneLines();
    void drawDust(const RenderView& view);
    void drawOutlines(const RenderView& view);
    void drawAxes(const RenderView& view);
    void drawScreenLines(const std::vector<ScreenLine>& lines);
    void drawBodies(const RenderView& view, const PixelBox& part);
    void drawFullscreen() const;
    void drawScaled(const RenderTarget& source, float weight) const;

    RenderPrograms programs;
    OutlinePass outlines;
    TransparencyPass transparency;
    SceneBuffers scene;
    InstanceBuffer sceneLines{4, 4, 4, 4};
    InstanceBuffer sceneBoxes{4, 4, 4, 4};
    InstanceBuffer puffs{4, 4, 4};
    DepthCopy solidDepths;
    SceneSummary summary;  // of `scene`
    ShadowMap keyShadow{kShadowWidth};
    ShadowMap skyShadow{kSkyShadowWidth};
    std::optional<double> shadowStepFraction;  // of the content of keyShadow, if from the key light's centre
    Light light = Light::Plain;
    FrameBlock frame{};
    GlBuffer frameUniforms = GlBuffer::create();
    GlVertexArray emptyArray = GlVertexArray::create();  // for draws without vertex attributes
    GlVertexArray lineArray = GlVertexArray::create();
    GlBuffer lineBuffer = GlBuffer::create();
};

}  // namespace rubble
