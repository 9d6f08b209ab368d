// Selects the variant of the ground that is of concrete.
#define CONCRETE
