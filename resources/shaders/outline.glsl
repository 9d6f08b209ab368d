// The marks of a texel of the outline mask, beside the number of its outline; 0: no outline.
const uint kOutlineHovered = 0x80000000u;
const uint kOutlineOccluded = 0x40000000u;
