// Pictures in double (by the import) and in float.
import { five, same_bits } from './pictures_of_five.mjs';

for (const scene of five) same_bits(scene, 'float');
