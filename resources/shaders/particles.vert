// Billboards of what flies after impacts and breaks: an instance of two triangles each. Kinds as in ParticleKind.
layout(location = 0) in vec4 centre;          // w: radius, m
layout(location = 1) in vec4 previousOffset;  // position one step earlier minus position now; w: opacity
layout(location = 2) in vec4 colour;          // sRGB; w: kind, plus of dust the seed of its noise in [0, 1)
out vec2 corner;
out float eyeDistance;  // view depth, m
out float height;       // above the ground, m
flat out vec4 particleColour;  // sRGB and opacity; of dust in the light
flat out vec3 shadedColour;    // of dust, where it shades itself
flat out vec2 lightOnScreen;   // where dust is lit from: shorter the more from before or behind
flat out float particleRadius;
flat out int particleKind;
flat out float particleSeed;

const int kDust = 0, kSpark = 1;

// Dust in the light, and where it shades itself. Its grains scatter light to all sides, so that the light of half a
// space counts.
void lightDust(vec3 p) {
    vec3 albedo = linearOf(colour.rgb), high = vec3(0.0, 1.0, 0.0);
    vec3 key = keyLight.rgb * lightReached(p, high).y * (0.4 + 0.6 * max(keyDirection.y, 0.0));
    vec3 above = diffuseSky(high), below = 0.6 * groundLight.rgb + 0.45 * above;
    particleColour.rgb = displayed(albedo * (above + 0.75 * key));
    shadedColour = displayed(albedo * (below + 0.35 * key));
    vec3 towards = normalize(keyDirection.xyz + 0.7 * high);
    lightOnScreen = vec2(dot(towards, right.xyz), dot(towards, up.xyz));
}

void main() {
    int number = gl_VertexID % 6;
    corner = vec2(number == 1 || number == 2 || number == 4 ? 1.0 : -1.0,
                  number == 0 || number == 1 || number == 3 ? -1.0 : 1.0);
    particleKind = int(colour.w);
    particleColour = vec4(colour.rgb, previousOffset.w);
    particleRadius = centre.w;
    particleSeed = fract(colour.w);
    vec3 middle = centre.xyz + (1.0 - edges.w) * previousOffset.xyz, p = middle;
    if (particleKind == kDust) lightDust(middle);
    vec2 way = vec2(dot(previousOffset.xyz, right.xyz), dot(previousOffset.xyz, up.xyz));  // on screen
    float flown = length(way);
    if (particleKind == kSpark && flown > 1e-6) {  // as long as its flight in a step
        vec2 along = way / flown, across = vec2(-along.y, along.x);
        vec2 place = corner.x * (centre.w + 0.5 * flown) * along + corner.y * centre.w * across;
        p += place.x * right.xyz + place.y * up.xyz;
    } else {
        p += centre.w * (corner.x * right.xyz + corner.y * up.xyz);
    }
    eyeDistance = dot(eye.xyz - p, back.xyz);
    height = p.y - ground.y;
    gl_Position = clipFromScene * vec4(p, 1.0);
}
