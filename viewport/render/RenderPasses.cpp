#include "viewport/render/RenderPasses.h"

#include "viewport/render/ScaleBar.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cstddef>
#include <string>

namespace rubble {

/// Parameters of a pass that draws edges over a faint fill.
struct EdgePass {
    glm::vec4 line{0.0f};
    glm::vec4 fill{0.0f};
    float width = 1.0f;
    std::uint32_t depthFunction = GL_LEQUAL;  // GL_ALWAYS: not occluded
    SceneBuffers::Part part = SceneBuffers::Part::Bodies;
};

namespace {

void setCapability(std::uint32_t capability, bool isOn) { isOn ? glEnable(capability) : glDisable(capability); }

/// Colours over others, by their opacity.
void setBlending() { glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA); }

glm::vec4 withOpacity(glm::vec4 colour, float opacity) { return {glm::vec3(colour), opacity}; }

}  // namespace

void RenderPasses::setScene(std::shared_ptr<const RenderScene> made) {
    summary = summaryOf(*made);
    keyContent = {};
    singleSky.invalidate();
    sceneLines.write(std::span(made->lines));
    sceneBoxes.write(std::span(made->boxes));
    particles.write(std::span(made->particles));
    chips.write(std::span(made->chips));
    decals.write(std::span(made->decals));
    scene.upload(std::move(made));
}

void RenderPasses::setFrame(const FrameBlock& block) {
    frame = block;
    glBindBuffer(GL_UNIFORM_BUFFER, frameUniforms.id());
    glBufferData(GL_UNIFORM_BUFFER, sizeof frame, &frame, GL_STREAM_DRAW);
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, frameUniforms.id());
}

void RenderPasses::setSky(const RenderSettings& settings) {
    if (settings.skyFile) {
        if (skyLight.background != settings.skyFile->background) {
            skyLight = *settings.skyFile;
            reflections.upload(skyLight.reflections);
            skyTexture.upload(*skyLight.background);
        }
        skyTexture.bind();
    } else if (const Sky wanted = skyOf(settings.sky, settings.theme); wanted != skyLight.sky || skyLight.background) {
        skyLight = skyLightOf(wanted);
        reflections.upload(skyLight.reflections);
    }
    reflections.bind();
}

void RenderPasses::drawFullscreen() const {
    glBindVertexArray(emptyArray.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

/// Fills the bound framebuffer with a target's colours times a weight.
void RenderPasses::drawScaled(const RenderTarget& source, float weight) const {
    glDisable(GL_DEPTH_TEST);
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(TextureUnit::Source));
    glBindTexture(GL_TEXTURE_2D, source.colourTexture());
    programs.mean.use();
    programs.mean.set("weight", weight);
    drawFullscreen();
}

void RenderPasses::setShadows(const RenderView& view, const LightSample& sample, bool isSingle) {
    frame = frameBlock(view, *scene.scene(), summary, skyLight, sample);
    const bool isDrawn = view.settings.hasShadows && view.settings.shading == Shading::Faces;
    hasShadows = isDrawn && !summary.bounds.isEmpty();
    setFrame(frame);
    if (scene.hasFinishes()) finishTexture.bind();
    scene.setView({.clipFromScene = frame.clipFromScene,
                   .eye = frame.eye,
                   .pixelsOfMetre = frame.viewport.z,
                   .minFragmentPixels = static_cast<float>(view.minFragmentPixels * view.resolution),
                   .areCracksHidden = !view.settings.hasOverlays});
    if (!hasShadows) return;
    key = isSingle && view.resolution == 1.0 ? &singleKey : &smallKey;
    sky = isSingle ? &singleSky : &sampledSky;
    const KeyContent content{.map = key,
                             .stepFraction = scene.scene()->previousPoses.empty() ? 1.0 : view.stepFraction,
                             .region = lightRegion(summary.boundsAt(view.stepFraction), view.camera),
                             .direction = sample.keyDirection};
    if (!isSingle || keyContent != content) {
        key->draw(scene, programs, sample.keyDirection, content.region, summary.hasTransparent);
        keyContent = isSingle ? content : KeyContent{};
    }
    if (!isSingle || skyStepFraction != content.stepFraction) sky->invalidate();
    if (isSingle) skyStepFraction = content.stepFraction;
    sky->draw(scene, programs, sample.sky, content.region, view.skyMaps);
    frame.keyFromScene = key->textureFromScene();
    setFrame(frame);
}

void RenderPasses::invalidateShadows() {
    keyContent = {};
    singleSky.invalidate();
    sampledSky.invalidate();
}

void RenderPasses::setLight(const RenderView& view) {
    if (!hasShadows) return;
    key->bind();
    sky->bind(scene.scene()->origin);
    lightBuffer.draw(scene, programs, view.size);
    lightBuffer.bind();
}

const ShaderProgram& RenderPasses::lit(const LitPrograms& variants) const {
    return hasShadows ? variants.shadowed : variants.plain;
}

/// Depths first, so that no pixel is shaded that another hides, where that costs less than it saves.
void RenderPasses::drawSolid(ImageSize size) {
    constexpr std::size_t kMinPixels = 2;  // a triangle
    glEnable(GL_CULL_FACE);
    glDepthFunc(GL_LESS);
    const auto pixels = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
    if (pixels > kMinPixels * scene.bodyTriangles()) {
        glEnable(GL_POLYGON_OFFSET_FILL);
        glPolygonOffset(0.0f, 4.0f);  // behind: the first of equal depths is seen, and rounding may differ
        drawDepths(kOpaqueSurfaces);
        glDisable(GL_POLYGON_OFFSET_FILL);
    }
    const auto drawWith = [&](const ShaderProgram& program, SceneBuffers::Batches batches) {
        program.use();
        program.set("surfaces", kOpaqueSurfaces);
        scene.draw(SceneBuffers::Part::Bodies, batches);
    };
    drawWith(lit(programs.solid.plain), SceneBuffers::Batches::Plain);
    if (scene.hasFinishes()) drawWith(lit(programs.solid.finished), SceneBuffers::Batches::Finished);
    if (scene.hasTextures()) drawWith(lit(programs.solid.textured), SceneBuffers::Batches::Textured);
    glDisable(GL_CULL_FACE);
}

void RenderPasses::drawTransparent(const RenderView& view) {
    if (summary.hasTransparent)
        transparency.draw(
            scene, view.size,
            {lit(programs.transparent.plain), lit(programs.transparent.finished), lit(programs.transparent.textured)},
            view.camera.distance);
}

void RenderPasses::drawEdges(const EdgePass& pass) {
    glEnable(GL_BLEND);
    glDepthMask(GL_FALSE);
    glDepthFunc(pass.depthFunction);
    setCapability(GL_POLYGON_OFFSET_FILL, pass.depthFunction == GL_LEQUAL);
    glPolygonOffset(-1.0f, -2.0f);
    programs.wires.use();
    programs.wires.set("lineColour", pass.line);
    programs.wires.set("fillColour", pass.fill);
    programs.wires.set("lineWidth", pass.width * frame.viewport.w);
    scene.draw(pass.part);
    glDisable(GL_POLYGON_OFFSET_FILL);
    glDisable(GL_BLEND);
    glDepthMask(GL_TRUE);
}

void RenderPasses::drawWireframe(const RenderView& view) {
    const glm::vec4 colour = environmentOf(view.settings.sky, view.settings.theme, skyLight).wires;
    drawDepths(kAllSurfaces);
    drawEdges({.line = withOpacity(colour, 0.16f), .width = 0.6f, .depthFunction = GL_ALWAYS});
    drawEdges({.line = withOpacity(colour, 0.85f), .fill = withOpacity(colour, 0.03f), .width = 0.7f});
}

void RenderPasses::drawHulls(const RenderView& view) {
    const glm::vec4 colour = environmentOf(view.settings.sky, view.settings.theme, skyLight).hulls;
    const auto part = SceneBuffers::Part::Hulls;
    drawEdges({.line = withOpacity(colour, 0.2f), .width = 0.7f, .depthFunction = GL_ALWAYS, .part = part});
    drawEdges({.line = withOpacity(colour, 1.0f), .fill = withOpacity(colour, 0.14f), .width = 1.3f, .part = part});
}

/// Where there are no bodies.
void RenderPasses::drawGround(const RenderView& view) {
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_LEQUAL);
    const bool isConcrete = view.settings.sky != SkyPreset::Studio;
    lit(skyLight.background ? programs.skyFileGround : isConcrete ? programs.concreteGround : programs.ground).use();
    drawFullscreen();
    glDepthMask(GL_TRUE);
}

void RenderPasses::drawSceneLines() {
    if (sceneLines.count() + sceneBoxes.count() == 0) return;
    glEnable(GL_BLEND);
    glDepthMask(GL_FALSE);
    glEnable(GL_DEPTH_CLAMP);  // the depth range is fitted to the bodies
    programs.sceneLines.use();
    const auto drawAs = [&](GLenum depthFunction, float strength) {
        glDepthFunc(depthFunction);
        programs.sceneLines.set("strength", strength);
        programs.sceneLines.set("ofBoxes", 1.0f);
        sceneBoxes.draw(72);
        programs.sceneLines.set("ofBoxes", 0.0f);
        sceneLines.draw(18);
    };
    drawAs(GL_GREATER, 0.25f);
    drawAs(GL_LEQUAL, 1.0f);
    glDisable(GL_DEPTH_CLAMP);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

/// Draws squares that a shader compares with the depths of what was drawn before.
void RenderPasses::drawOverDepths(const RenderView& view, const ShaderProgram& program,
                                  const InstanceBuffer& instances) {
    if (instances.count() == 0) return;
    solidDepths.copyBound(view.size);
    solidDepths.bind();
    glEnable(GL_BLEND);
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_DEPTH_CLAMP);
    program.use();
    instances.draw(6);
    glDisable(GL_DEPTH_CLAMP);
    glEnable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
}

/// Draws each body that has marks once more, over itself.
void RenderPasses::drawMarks() {
    const std::vector<SurfaceMark>& marks = scene.scene()->surfaceMarks;
    if (marks.empty()) return;
    glEnable(GL_BLEND);
    glBlendFunc(GL_DST_COLOR, GL_SRC_COLOR);  // twice the product
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_LEQUAL);
    glEnable(GL_CULL_FACE);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(-1.0f, -2.0f);
    programs.marks.use();
    programs.marks.set("surfaces", kOpaqueSurfaces);
    for (std::size_t first = 0, next = 0; first < marks.size(); first = next) {
        while (next < marks.size() && marks[next].body == marks[first].body) ++next;
        const std::size_t count = std::min(next - first, kMaxMarksOfBody);
        for (std::size_t k = 0; k < count; ++k) {  // the latest of its marks
            const std::string index = "[" + std::to_string(k) + "]";
            programs.marks.set(("markCentres" + index).c_str(), marks[next - count + k].centre);
            programs.marks.set(("markNormals" + index).c_str(), marks[next - count + k].normal);
        }
        programs.marks.set("markCount", static_cast<std::uint32_t>(count));
        scene.drawBody(marks[first].body);
    }
    glDisable(GL_POLYGON_OFFSET_FILL);
    glDisable(GL_CULL_FACE);
    glDepthMask(GL_TRUE);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    setBlending();
    glDisable(GL_BLEND);
}

/// Chips with their shadows on the ground, which is not in the depth buffer.
void RenderPasses::drawChips() {
    if (chips.count() == 0) return;
    glDepthFunc(GL_LEQUAL);
    glEnable(GL_DEPTH_CLAMP);  // the depth range is fitted to the bodies
    glEnable(GL_BLEND);
    glDepthMask(GL_FALSE);
    programs.chipShadows.use();
    chips.draw(6);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    lit(programs.chips).use();
    chips.draw(18);
    glDisable(GL_DEPTH_CLAMP);
}

/// Of the selected bodies, over the bound framebuffer.
void RenderPasses::drawOutlines(const RenderView& view) {
    if (summary.selected.isEmpty()) return;
    GLint image = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &image);
    const auto bound = static_cast<std::uint32_t>(image);
    outlines.draw(scene, view, {.outlined = summary.selected, .depths = bound, .image = bound});
}

/// The depths of bodies alone; `surfaces`: see bodies.glsl.
void RenderPasses::drawDepths(std::uint32_t surfaces) {
    glDepthMask(GL_TRUE);
    glEnable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glClear(GL_DEPTH_BUFFER_BIT);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    programs.depth.use();
    programs.depth.set("clipFromSceneOfLight", frame.clipFromScene);
    programs.depth.set("surfaces", surfaces);
    programs.depth.set("pattern", 0u);
    glDepthFunc(GL_LESS);
    scene.draw(SceneBuffers::Part::Bodies);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void RenderPasses::drawAxes(const RenderView& view) {
    if (view.settings.hasAxes) drawScreenLines(axesIndicator(view.camera, view.settings.scale));
    if (!view.settings.hasScaleBar || !view.settings.hasGrid || !scene.scene()->isOutdoors) return;
    const bool isDark = environmentOf(view.settings.sky, view.settings.theme, skyLight).isDark;
    const glm::vec3 ink(isDark ? 0.92f : 0.12f), paper(isDark ? 0.05f : 1.0f);
    drawScreenLines(scaleBar(view.camera, view.size, view.settings.scale, ink, paper));
}

void RenderPasses::drawScreenLines(const std::vector<ScreenLine>& lines) {
    glBindVertexArray(lineArray.id());
    glBindBuffer(GL_ARRAY_BUFFER, lineBuffer.id());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(lines.size() * sizeof(ScreenLine)), lines.data(),
                 GL_STREAM_DRAW);
    const auto describe = [](GLuint attribute, GLint count, std::size_t offset) {
        glVertexAttribPointer(attribute, count, GL_FLOAT, GL_FALSE, sizeof(ScreenLine),
                              reinterpret_cast<const void*>(offset));
        glVertexAttribDivisor(attribute, 1);
        glEnableVertexAttribArray(attribute);
    };
    describe(0, 4, offsetof(ScreenLine, ends));
    describe(1, 4, offsetof(ScreenLine, colour));
    describe(2, 1, offsetof(ScreenLine, radius));
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    programs.screenLines.use();
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(lines.size()));
    glDisable(GL_BLEND);
}

void RenderPasses::drawImage(const RenderView& view) {
    setBlending();
    glDepthMask(GL_TRUE);
    glEnable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glClear(GL_DEPTH_BUFFER_BIT);
    const bool isSolid = view.settings.shading == Shading::Faces;
    if (isSolid) drawSolid(view.size);
    drawGround(view);
    if (!isSolid) drawWireframe(view);
    if (isSolid) drawMarks();
    if (isSolid) drawOverDepths(view, programs.decals, decals);
    if (isSolid) drawChips();
    if (isSolid) drawTransparent(view);
    const bool hasOverlays = view.settings.hasOverlays;
    if (hasOverlays) {
        drawHulls(view);
        drawSceneLines();
    }
    if (isSolid) drawOverDepths(view, lit(programs.particles), particles);
    if (!hasOverlays) return;
    drawOutlines(view);
    drawAxes(view);
}

}  // namespace rubble
