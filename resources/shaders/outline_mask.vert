// The selected bodies for their outlines, or the hovered one.
flat out uint outline;  // the bodies of one outline share a number

void main() {
    uvec4 appearance = appearanceOfBody();
    bool isHovered = (appearance.z & kHovered) != 0u;
    bool isOutlined = hovered.x != 0u ? isHovered : isHovered || (appearance.z & kSelected) != 0u;
    bool isShown = (appearance.z & kHidden) == 0u && isOutlined;
    outline = isHovered ? kOutlineHovered | uint(bodyIndex() + 1) : appearance.w;
    gl_Position = isShown ? clipFromScene * vec4(pointInScene(poseOfBody()), 1.0) : kClipped;
}
