// Draws a line where the numbers of the outline mask change.
uniform usampler2D mask;
uniform float lineWidth;  // pixels, outside of an outline
out vec4 pixel;

const float kShared = 0.6;     // of the width, on each side where two outlined bodies meet
const float kBrighter = 0.14;  // opacity of the white over a hovered surface

const ivec2 kAround[8] = ivec2[8](ivec2(1, 0), ivec2(-1, 0), ivec2(0, 1), ivec2(0, -1), ivec2(1, 1), ivec2(-1, -1),
                                  ivec2(1, -1), ivec2(-1, 1));

uint maskAt(ivec2 at) { return texelFetch(mask, clamp(at, ivec2(0), textureSize(mask, 0) - 1), 0).r; }

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    int far = int(ceil(lineWidth));
    uint here = maskAt(at), number = here & ~kOutlineOccluded;
    bool isUniform = true;  // of a coarse grid: nearly all pixels are far from any outline
    for (int k = 0; k < 8; ++k) isUniform = isUniform && maskAt(at + far * kAround[k]) == here;
    uint found = here;       // all marks of outlines nearby
    bool isVisible = false;  // one of them is not occluded
    float nearest = 1e3;     // distance from an outlined body, inside of one from another, pixels
    for (int y = isUniform ? far + 1 : -far; y <= far; ++y) {
        for (int x = -far; x <= far; ++x) {
            uint there = maskAt(at + ivec2(x, y));
            if (there != 0u) isVisible = isVisible || (there & kOutlineOccluded) == 0u;
            found |= there;
            bool isOther = there != 0u && (there & ~kOutlineOccluded) != number;
            if (isOther) nearest = min(nearest, length(vec2(x, y)));
        }
    }
    float width = number == 0u ? lineWidth : kShared * lineWidth;  // small bodies stay visible inside their outlines
    float cover = 1.0 - smoothstep(width - 0.6, width + 0.6, nearest);
    bool isBrighter = number != 0u && (here & kOutlineHovered) != 0u && (here & kOutlineOccluded) == 0u;
    if (cover <= 0.0 && !isBrighter) discard;
    vec3 colour = (found & kOutlineHovered) != 0u ? mix(accent.rgb, vec3(1.0), 0.45) : accent.rgb;
    float line = cover * (isVisible ? 1.0 : 0.4), fill = isBrighter ? kBrighter : 0.0;
    float opacity = line + fill * (1.0 - line);
    pixel = vec4(mix(vec3(1.0), colour, line / opacity), opacity);
}
