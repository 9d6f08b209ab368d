// Dust: a soft particle with a noisy edge, which shades itself and fades where it meets solid surfaces and the ground.
// Or a spark, a flash.
uniform sampler2D depths;  // of the solid surfaces
in vec2 corner;
in float eyeDistance;
in float height;
flat in vec4 particleColour;
flat in vec3 shadedColour;
flat in vec2 lightOnScreen;
flat in float particleRadius;
flat in int particleKind;
flat in float particleSeed;
out vec4 pixel;

float random(vec2 p) { return fract(sin(dot(p, vec2(12.9898, 78.233))) * 43758.5453); }
float noise(vec2 p) {
    vec2 cell = floor(p), part = smoothstep(0.0, 1.0, fract(p));
    return mix(mix(random(cell), random(cell + vec2(1.0, 0.0)), part.x),
               mix(random(cell + vec2(0.0, 1.0)), random(cell + vec2(1.0, 1.0)), part.x), part.y);
}

float surfaceDepth() { return viewDepthOf(texelFetch(depths, ivec2(gl_FragCoord.xy), 0).r); }

// A glow, white in its middle.
vec4 glow(float sharpness) {
    float near = max(1.0 - dot(corner, corner), 0.0);
    float bright = pow(near, sharpness);
    float seen = eyeDistance > surfaceDepth() ? 0.0 : bright * particleColour.a;
    return vec4(mix(particleColour.rgb, vec3(1.0), bright * bright), seen);
}

vec4 dust() {
    float radial = length(corner);
    if (radial >= 1.0) discard;
    vec2 p = 1.7 * corner + 31.0 * particleSeed;
    float cloud = 0.65 * noise(p) + 0.35 * noise(2.3 * p + 5.0);
    float density = (1.0 - smoothstep(0.15, 1.0, radial)) * smoothstep(0.1, 0.7, cloud + 0.35 * (1.0 - radial));
    float thickness = max(particleRadius * sqrt(1.0 - radial * radial), 1e-4);  // of a sphere
    float soft = clamp(0.5 + 0.5 * (surfaceDepth() - eyeDistance) / thickness, 0.0, 1.0);
    float low = smoothstep(-0.5, 0.6, height / particleRadius);
    float lit = clamp(0.5 + 0.45 * dot(corner, lightOnScreen) + 0.7 * (cloud - 0.5), 0.0, 1.0);
    return vec4(mix(shadedColour, particleColour.rgb, lit), particleColour.a * density * soft * low);
}

void main() {
    switch (particleKind) {
        case 0: pixel = dust(); break;
        case 1: pixel = glow(1.0); break;
        default: pixel = glow(3.0);
    }
}
