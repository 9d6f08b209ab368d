// Lets a part of the light through a transparent surface: discards texels of the shadow map in a fine pattern, which
// differs from sample to sample. Source: Jimenez, "Next Generation Post Processing in Call of Duty", 2014.
uniform float patternIndex;
flat in float opacity;

void main() {
    vec2 p = gl_FragCoord.xy + 5.588238 * patternIndex;
    if (fract(52.9829189 * fract(dot(p, vec2(0.06711056, 0.00583715)))) >= opacity) discard;
}
