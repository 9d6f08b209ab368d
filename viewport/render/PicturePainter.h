#pragma once

#include "viewport/render/AxesCross.h"
#include "viewport/render/FrameBlock.h"
#include "viewport/render/InstanceBuffer.h"
#include "viewport/render/RenderPrograms.h"
#include "viewport/render/RenderTarget.h"
#include "viewport/render/SceneBuffers.h"
#include "viewport/render/ShadowMap.h"

#include <optional>

namespace rubble {

/// A part of a picture, pixels from the lower left corner.
struct PixelBox {
    int x = 0, y = 0, width = 0, height = 0;
    bool contains(int px, int py) const { return px >= x && py >= y && px < x + width && py < y + height; }
};

inline constexpr int kShadowWidth = 2048;    // texels: some 5 mm at a house
inline constexpr int kSkyShadowWidth = 512;  // soft: the sky is wide

struct LinePass;

/// Draws what a picture is made of, one thing after the other, to the framebuffer that is bound.
struct PicturePainter {
    explicit PicturePainter(RenderPrograms made) : programs(std::move(made)) {}

    void setScene(std::shared_ptr<const RenderScene> made);
    void setFrame(const FrameBlock& block);
    void drawShadows(const PictureView& view, const std::optional<LightSample>& lightSample);
    void drawPicture(const PictureView& view);
    const ShaderProgram& lit(const LitPrograms& ways) const;
    void drawBackground();
    void drawSolid();
    void drawWires(const PictureView& view);
    void drawHulls(const PictureView& view);
    void drawLines(const LinePass& pass);
    void drawGround(const PictureView& view);
    void drawSpans();
    void drawDust(const PictureView& view);
    void drawAxes(const PictureView& view);
    void drawStrokes(const std::vector<Stroke>& strokes);
    void drawBodies(const PictureView& view, const PixelBox& part);
    void drawWhole() const;
    void drawTimes(const RenderTarget& source, float share) const;

    RenderPrograms programs;
    SceneBuffers scene;
    InstanceBuffer spans{4, 4, 4, 4};
    InstanceBuffer boxes{4, 4, 4, 4};
    InstanceBuffer puffs{4, 4, 4};
    DepthCopy solidDepths;
    SceneSummary summary;  // of `scene`
    ShadowMap keyShadow{kShadowWidth};
    ShadowMap skyShadow{kSkyShadowWidth};
    std::optional<double> shadowsMoment;  // of `scene`, that keyShadow is of, by the middle of the lights
    Light light = Light::Plain;
    FrameBlock frame{};
    GlBuffer frameBuffer = GlBuffer::made();
    GlVertexArray nothing = GlVertexArray::made();  // for what needs no vertices
    GlVertexArray strokeArray = GlVertexArray::made();
    GlBuffer strokeBuffer = GlBuffer::made();
};

}  // namespace rubble
