// A number in [0, 1) for a point of the integer lattice.
// Source: Jarzynski, Olano, "Hash functions for GPU rendering", 2020 (PCG).
float randomAt(ivec2 at) {
    uint state = (uint(at.x & 4095) + 4096u * uint(at.y & 4095)) * 747796405u + 2891336453u;
    uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return float(((word >> 22u) ^ word) & 0xffffu) / 65536.0;
}
