// Dust: a soft particle with a noisy edge, lit from above, that fades where it meets solid surfaces. Or a splinter, a
// chip, a spark, a flash.
uniform sampler2D depths;  // of the solid surfaces
in vec2 corner;
in float eyeDistance;
in float height;
flat in vec4 particleColour;
flat in float particleRadius;
flat in int particleKind;
flat in float particlePhase;
out vec4 pixel;

float random(vec2 p) { return fract(sin(dot(p, vec2(12.9898, 78.233))) * 43758.5453); }
float noise(vec2 p) {
    vec2 cell = floor(p), part = smoothstep(0.0, 1.0, fract(p));
    return mix(mix(random(cell), random(cell + vec2(1.0, 0.0)), part.x),
               mix(random(cell + vec2(0.0, 1.0)), random(cell + vec2(1.0, 1.0)), part.x), part.y);
}

const float kSlenderness = 4.0;  // of a splinter
const float kGlint = 16.0;       // exponent: it glints in few directions

float surfaceDepth() { return viewDepthOf(texelFetch(depths, ivec2(gl_FragCoord.xy), 0).r); }

bool isHidden() { return eyeDistance > surfaceDepth(); }
mat2 rotation() {
    float angle = 6.2831853 * particlePhase;
    return mat2(cos(angle), sin(angle), -sin(angle), cos(angle));
}
// How much of the pixel lies inside an edge: positive within.
float coverOf(float inside) { return clamp(inside / max(fwidth(inside), 1e-6) + 0.5, 0.0, 1.0); }

// A rhombus that rotates; at four rotations, its own ones, it reflects the light.
vec4 splinter() {
    vec2 p = abs(rotation() * corner);
    float cover = coverOf(1.0 - p.x - kSlenderness * p.y);
    float glint = pow(abs(cos(2.0 * 6.2831853 * particlePhase + 900.0 * particleRadius)), kGlint);
    return vec4(mix(particleColour.rgb * 0.8 * depth.w, vec3(1.0), glint),
                isHidden() ? 0.0 : cover * particleColour.a * (0.45 + 0.55 * glint));
}

// A rectangle that rotates and tumbles: its brightness follows.
vec4 chip() {
    vec2 p = abs(rotation() * corner);
    float cover = coverOf(0.7 - max(p.x, 1.5 * p.y));
    float light = (0.95 + 0.25 * sin(2.0 * 6.2831853 * particlePhase + 900.0 * particleRadius)) * depth.w;
    return vec4(min(particleColour.rgb * light, vec3(1.0)), isHidden() ? 0.0 : cover * particleColour.a);
}

// A glow, white in its middle.
vec4 glow(float sharpness) {
    float near = max(1.0 - dot(corner, corner), 0.0);
    float bright = pow(near, sharpness);
    return vec4(mix(particleColour.rgb, vec3(1.0), bright * bright), isHidden() ? 0.0 : bright * particleColour.a);
}

vec4 dust() {
    float radial = length(corner);
    if (radial >= 1.0) discard;
    vec2 p = 1.7 * corner + 31.0 * particlePhase;
    float cloud = 0.65 * noise(p) + 0.35 * noise(2.3 * p + 5.0);
    float density = (1.0 - smoothstep(0.15, 1.0, radial)) * smoothstep(0.1, 0.7, cloud + 0.35 * (1.0 - radial));
    float thickness = max(particleRadius * sqrt(1.0 - radial * radial), 1e-4);  // of a sphere
    float soft = clamp(0.5 + 0.5 * (surfaceDepth() - eyeDistance) / thickness, 0.0, 1.0);
    float low = clamp(0.5 + height / particleRadius, 0.0, 1.0);
    float light = (0.80 + 0.16 * corner.y + 0.10 * (cloud - 0.5)) * depth.w;
    return vec4(min(particleColour.rgb * light, vec3(1.0)), particleColour.a * density * soft * low);
}

void main() {
    switch (particleKind) {
        case 0: pixel = dust(); break;
        case 1: pixel = splinter(); break;
        case 2: pixel = chip(); break;
        case 3: pixel = glow(1.0); break;
        default: pixel = glow(3.0);
    }
}
