// Billboards of what flies after impacts and breaks: an instance of two triangles each. Kinds as in ParticleKind.
layout(location = 0) in vec4 centre;          // w: radius, m
layout(location = 1) in vec4 previousOffset;  // position one step earlier minus position now; w: opacity
layout(location = 2) in vec4 colour;          // sRGB; w: kind, plus its phase in [0, 1): seed of noise, or rotation
out vec2 corner;
out float eyeDistance;  // view depth, m
out float height;       // above the ground, m
flat out vec4 particleColour;
flat out float particleRadius;
flat out int particleKind;
flat out float particlePhase;

const int kSpark = 3;

void main() {
    int number = gl_VertexID % 6;
    corner = vec2(number == 1 || number == 2 || number == 4 ? 1.0 : -1.0,
                  number == 0 || number == 1 || number == 3 ? -1.0 : 1.0);
    particleKind = int(colour.w);
    vec3 p = centre.xyz + (1.0 - edges.w) * previousOffset.xyz;
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
    particleColour = vec4(colour.rgb, previousOffset.w);
    particleRadius = centre.w;
    particlePhase = fract(colour.w);
    gl_Position = clipFromScene * vec4(p, 1.0);
}
