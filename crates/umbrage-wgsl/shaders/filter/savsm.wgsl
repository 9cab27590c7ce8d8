// Mean and variance of depth over a box of a given radius, from a summed-area table (Lauritzen 2007).

import package::moments::vsm::umbrage_moments_visibility;
import package::sampling::summed::umbrage_filter;
