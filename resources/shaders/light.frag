// Fills the light buffer: for the solid surfaces, and the ground where there are none.
uniform sampler2D depths;
uniform sampler2D normals;
in vec2 place;
out vec4 texel;

const float kFarAway = 1e6;  // m, of the sky

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec4 surface = texelFetch(normals, at, 0);
    Sight sight = sightAt(place);
    vec3 n = vec3(0.0, 1.0, 0.0);
    float d = 0.0;
    bool isSeen = surface.a > 0.5 || meetsGround(sight, d);
    if (surface.a > 0.5) {
        n = normalize(2.0 * surface.xyz - 1.0);
        d = viewDepthOf(texelFetch(depths, at, 0).r);
    }
    vec3 point = sight.from + d * sight.along;
    float turn = fract(gradientNoise(gl_FragCoord.xy) + jitter.z);
    if (!isSeen) d = kFarAway;
    bool isFacing = dot(n, keyDirection.xyz) > 0.0;
    float sky = isSeen ? skyReached(point + skyCount.y * n, n, (at.x + at.y) & 1, turn) : 1.0;
    float key = isSeen && isFacing ? keyReachedSoftly(point + skyCount.z * n, n, turn) : isSeen ? 0.0 : 1.0;
    texel = vec4(sky, key, d, surface.a > 0.5 ? packedNormal(n) : kGroundTexel);
}
