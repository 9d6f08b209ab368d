#include "viewport/render/PicturePainter.h"

#include "viewport/render/ScaleBar.h"

#include <epoxy/gl.h>

#include <cstddef>

namespace rubble {

/// What is drawn beside or over solid faces.
struct LinePass {
    glm::vec4 line{0.0f};
    glm::vec4 fill{0.0f};
    float width = 1.0f;
    std::uint32_t onlyMarks = 0;
    std::uint32_t depthFunction = GL_LEQUAL;  // GL_ALWAYS: through everything
    SceneBuffers::Part part = SceneBuffers::Part::Bodies;
};

namespace {

void setCapability(std::uint32_t capability, bool isOn) { isOn ? glEnable(capability) : glDisable(capability); }

glm::vec4 withOpacity(glm::vec4 colour, float opacity) { return {glm::vec3(colour), opacity}; }

}  // namespace

void PicturePainter::setScene(std::shared_ptr<const RenderScene> made) {
    summary = summaryOf(*made);
    shadowsMoment.reset();
    spans.write(std::span(made->strokes));
    boxes.write(std::span(made->boxes));
    puffs.write(std::span(made->puffs));
    scene.upload(std::move(made));
}

void PicturePainter::setFrame(const FrameBlock& block) {
    frame = block;
    glBindBuffer(GL_UNIFORM_BUFFER, frameBuffer.id());
    glBufferData(GL_UNIFORM_BUFFER, sizeof frame, &frame, GL_STREAM_DRAW);
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, frameBuffer.id());
}

void PicturePainter::drawWhole() const {
    glBindVertexArray(nothing.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

/// Covers what is bound with a target's colours times a number.
void PicturePainter::drawTimes(const RenderTarget& source, float share) const {
    glDisable(GL_DEPTH_TEST);
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(TextureUnit::Source));
    glBindTexture(GL_TEXTURE_2D, source.colourTexture());
    programs.mean.use();
    programs.mean.set("share", share);
    drawWhole();
}

void PicturePainter::drawShadows(const PictureView& view, const std::optional<LightSample>& lightSample) {
    light = Light::Plain;
    if (!view.settings.hasShadows || view.settings.shading != Shading::Faces || summary.bounds.isEmpty()) return;
    light = lightSample ? Light::Sampled : Light::Shadowed;
    const double moment = scene.scene()->earlier.empty() ? 1.0 : view.moment;
    if (!lightSample && shadowsMoment == moment) return;
    setFrame(frame);  // for its exploded factor and its moment
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    keyShadow.draw(scene, programs.depth, lightSample ? lightSample->keyDirection : keyDirection(), summary.bounds);
    if (lightSample) skyShadow.draw(scene, programs.depth, lightSample->skyDirection, summary.bounds);
    shadowsMoment = lightSample ? std::nullopt : std::optional(moment);
}

const ShaderProgram& PicturePainter::lit(const LitPrograms& ways) const {
    return light == Light::Plain ? ways.plain : light == Light::Shadowed ? ways.shadowed : ways.sampled;
}

void PicturePainter::drawBackground() {
    glDisable(GL_DEPTH_TEST);
    glDepthMask(GL_FALSE);
    programs.sky.use();
    drawWhole();
    glDepthMask(GL_TRUE);
    glEnable(GL_DEPTH_TEST);
}

void PicturePainter::drawSolid() {
    glEnable(GL_CULL_FACE);
    glDepthFunc(GL_LESS);
    lit(scene.scene()->heats.empty() ? programs.solid : programs.heated).use();
    scene.draw(SceneBuffers::Part::Bodies);
    glDisable(GL_CULL_FACE);
}

void PicturePainter::drawLines(const LinePass& pass) {
    glEnable(GL_BLEND);
    glDepthMask(GL_FALSE);
    glDepthFunc(pass.depthFunction);
    setCapability(GL_POLYGON_OFFSET_FILL, pass.depthFunction == GL_LEQUAL);
    glPolygonOffset(-1.0f, -2.0f);
    programs.lines.use();
    programs.lines.set("lineColour", pass.line);
    programs.lines.set("fillColour", pass.fill);
    programs.lines.set("lineWidth", pass.width * frame.picture.w);
    programs.lines.set("onlyMarks", pass.onlyMarks);
    scene.draw(pass.part);
    glDisable(GL_POLYGON_OFFSET_FILL);
    glDisable(GL_BLEND);
    glDepthMask(GL_TRUE);
}

void PicturePainter::drawWires(const PictureView& view) {
    const glm::vec4 colour = surroundingsOf(view.settings.theme).wires;
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    programs.depth.use();
    programs.depth.set("clipFromSceneOfLight", frame.clipFromScene);
    glDepthFunc(GL_LESS);
    scene.draw(SceneBuffers::Part::Bodies);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    drawLines({.line = withOpacity(colour, 0.16f), .width = 0.6f, .depthFunction = GL_ALWAYS});
    drawLines({.line = withOpacity(colour, 0.85f), .fill = withOpacity(colour, 0.03f), .width = 0.7f});
}

void PicturePainter::drawHulls(const PictureView& view) {
    const glm::vec4 colour = surroundingsOf(view.settings.theme).hulls;
    const auto part = SceneBuffers::Part::Hulls;
    drawLines({.line = withOpacity(colour, 0.2f), .width = 0.7f, .depthFunction = GL_ALWAYS, .part = part});
    drawLines({.line = withOpacity(colour, 1.0f), .fill = withOpacity(colour, 0.14f), .width = 1.3f, .part = part});
}

void PicturePainter::drawGround(const PictureView& view) {
    if (!scene.scene()->hasGround) return;
    glEnable(GL_BLEND);
    glEnable(GL_DEPTH_CLAMP);  // it reaches beyond what the depth was made for
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_LEQUAL);
    glBindVertexArray(nothing.id());
    if (light != Light::Plain && !summary.bounds.isEmpty()) {
        lit(programs.shade).use();
        glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    }
    if (view.settings.hasGrid) {
        programs.grid.use();
        programs.grid.set("worldOrigin", gridOrigin(frame, *scene.scene()));
        glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    }
    glDepthMask(GL_TRUE);
    glDisable(GL_DEPTH_CLAMP);
    glDisable(GL_BLEND);
}

void PicturePainter::drawSpans() {
    if (spans.count() + boxes.count() == 0) return;
    glEnable(GL_BLEND);
    glDepthMask(GL_FALSE);
    glEnable(GL_DEPTH_CLAMP);  // they may reach beyond the bodies that the depth was made for
    programs.spans.use();
    const auto drawAs = [&](GLenum depthFunction, float strength) {
        glDepthFunc(depthFunction);
        programs.spans.set("strength", strength);
        programs.spans.set("ofBoxes", 1.0f);
        boxes.draw(72);
        programs.spans.set("ofBoxes", 0.0f);
        spans.draw(18);
    };
    drawAs(GL_GREATER, 0.25f);
    drawAs(GL_LEQUAL, 1.0f);
    glDisable(GL_DEPTH_CLAMP);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

void PicturePainter::drawDust(const PictureView& view) {
    if (puffs.count() == 0) return;
    solidDepths.take(view.size);
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(TextureUnit::Depths));
    glBindTexture(GL_TEXTURE_2D, solidDepths.texture());
    glEnable(GL_BLEND);
    glDisable(GL_DEPTH_TEST);  // the shader asks the copy
    glEnable(GL_DEPTH_CLAMP);
    programs.dust.use();
    puffs.draw(6);
    glDisable(GL_DEPTH_CLAMP);
    glEnable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
}

void PicturePainter::drawAxes(const PictureView& view) {
    if (view.settings.hasAxes) drawStrokes(axesCross(view.camera, view.settings.scale));
    if (!view.settings.hasGrid || !scene.scene()->isOutdoors) return;
    const bool isDark = view.settings.theme == Theme::Dark;
    const glm::vec3 ink(isDark ? 0.92f : 0.12f), paper(isDark ? 0.05f : 1.0f);
    drawStrokes(scaleBar(view.camera, view.size, view.settings.scale, ink, paper));
}

void PicturePainter::drawStrokes(const std::vector<Stroke>& strokes) {
    glBindVertexArray(strokeArray.id());
    glBindBuffer(GL_ARRAY_BUFFER, strokeBuffer.id());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(strokes.size() * sizeof(Stroke)), strokes.data(),
                 GL_STREAM_DRAW);
    const auto describe = [](GLuint attribute, GLint count, std::size_t offset) {
        glVertexAttribPointer(attribute, count, GL_FLOAT, GL_FALSE, sizeof(Stroke),
                              reinterpret_cast<const void*>(offset));
        glVertexAttribDivisor(attribute, 1);
        glEnableVertexAttribArray(attribute);
    };
    describe(0, 4, offsetof(Stroke, ends));
    describe(1, 4, offsetof(Stroke, colour));
    describe(2, 1, offsetof(Stroke, radius));
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    programs.strokes.use();
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(strokes.size()));
    glDisable(GL_BLEND);
}

void PicturePainter::drawPicture(const PictureView& view) {
    keyShadow.bind(TextureUnit::KeyShadow);
    skyShadow.bind(TextureUnit::SkyShadow);
    frame.keyFromScene = keyShadow.placeFromScene();
    frame.skyFromScene = skyShadow.placeFromScene();
    setFrame(frame);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glDepthMask(GL_TRUE);
    glClear(GL_DEPTH_BUFFER_BIT);
    drawBackground();
    const bool isSolid = view.settings.shading == Shading::Faces;
    if (isSolid)
        drawSolid();
    else
        drawWires(view);
    drawGround(view);
    drawHulls(view);
    if (summary.hasSelected && isSolid) {
        drawLines({.line = withOpacity(frame.accent, 0.45f),
                   .fill = withOpacity(frame.accent, 0.06f),
                   .width = 1.2f,
                   .onlyMarks = kSelected,
                   .depthFunction = GL_GREATER});
    }
    drawSpans();
    if (isSolid) drawDust(view);
    drawAxes(view);
}

void PicturePainter::drawBodies(const PictureView& view, const PixelBox& part) {
    setFrame(frameBlock(view, *scene.scene(), summary.bounds, {}));
    glEnable(GL_SCISSOR_TEST);
    glScissor(part.x, part.y, part.width, part.height);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    glEnable(GL_CULL_FACE);
    constexpr std::uint32_t kNothing[4] = {0, 0, 0, 0};
    glClearBufferuiv(GL_COLOR, 0, kNothing);
    glClear(GL_DEPTH_BUFFER_BIT);
    programs.pick.use();
    scene.draw(SceneBuffers::Part::Bodies);
    glDisable(GL_CULL_FACE);
    glDisable(GL_SCISSOR_TEST);
}

}  // namespace rubble
