in vec2 place;
out vec4 pixel;

// Dithers by less than one 8-bit step, which avoids banding.
float noise(vec2 p) { return fract(52.9829189 * fract(dot(p, vec2(0.06711056, 0.00583715)))) - 0.5; }

// A sky above a ground that fades into the horizon.
vec3 outdoors(vec3 direction) {
    float below = -direction.y, above = eye.y - ground.y;
    if (below <= 0.0) return mix(horizon.rgb, zenith.rgb, 1.0 - pow(1.0 + below, 4.0));
    if (above <= 0.0) return mix(horizon.rgb, soil.rgb, smoothstep(0.0, 0.2, below));
    float far = above / below;
    return mix(soil.rgb, horizon.rgb, far / (far + ground.w));
}

void main() {
    vec3 colour = mix(backgroundBottom.rgb, backgroundTop.rgb, smoothstep(0.0, 1.0, place.y));
    if (zenith.w > 0.5) {
        vec2 aside = 2.0 * place - 1.0;
        colour = outdoors(normalize(aside.x * right.w * right.xyz + aside.y * up.w * up.xyz - back.xyz));
    }
    pixel = vec4(colour + noise(gl_FragCoord.xy) / 255.0, 1.0);
}
