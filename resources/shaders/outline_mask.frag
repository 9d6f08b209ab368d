// Writes the number of an outline, and whether something hides it.
uniform sampler2D depths;  // of the solid surfaces
flat in uint outline;
out uint pixel;

void main() {
    float bias = 1.5 * fwidth(gl_FragCoord.z) + 2e-6;  // the depths may be those of another sample of the pixel
    bool isOccluded = gl_FragCoord.z - bias > texelFetch(depths, ivec2(gl_FragCoord.xy), 0).r;
    pixel = isOccluded ? outline | kOutlineOccluded : outline;
}
