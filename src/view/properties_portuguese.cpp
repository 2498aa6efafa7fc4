// What the numbers of a scene mean, in Portuguese, for the tooltips of their fields and for Help.

#include "view/text.h"

#include <array>

namespace raywalk {

std::span<const Explanation> portuguese_explanations() {
  static constexpr std::array table{
      Explanation{
          TextId::ambient,
          "ka: a parte da luz ambiente da cena que a superfície devolve, iluminada ou não. Representa toda a luz "
          "que nenhum raio segue."},
      Explanation{
          TextId::diffuse,
          "kd: a parte de uma luz que uma superfície fosca espalha por igual, vezes o cosseno entre a normal da "
          "superfície e a luz. É a cor própria do corpo."},
      Explanation{TextId::specular,
                  "ks: quanto brilha o reflexo borrado de uma luz: ks vezes (n.h) elevado ao polimento, onde h fica a "
                  "meio caminho entre a luz e o olho."},
      Explanation{TextId::shininess, "s: o expoente do brilho. 10 é largo e opaco, 100 pequeno e polido."},
      Explanation{
          TextId::reflection,
          "kr: a parte que se espelha. Acima de 0, SHADE forma um raio refletido e soma kr vezes o que ele traz."},
      Explanation{
          TextId::transmission,
          "kt: a parte que atravessa. Acima de 0, SHADE forma um raio refratado e soma kt vezes o que ele traz."},
      Explanation{TextId::ior,
                  "Quantas vezes mais lenta a luz é lá dentro, o que a dobra na superfície (lei de Snell): ar 1, água "
                  "1,33, vidro 1,5, diamante 2,4. Importa onde kt está acima de 0."},
      Explanation{
          TextId::dielectric,
          "Como vidro de verdade: quanto de kr + kt se espelha e quanto atravessa depende do ângulo (equações de "
          "Fresnel); quanto mais rasante a luz, mais se espelha. Desligado: kr e kt valem como estão."},
      Explanation{TextId::priority,
                  "Qual de dois corpos transparentes vale onde se sobrepõem: o de número maior e, entre iguais, aquele "
                  "em que a luz entrou por último."},
      Explanation{TextId::filtered_shadow,
                  "Um raio de sombra continua através deste corpo e traz kt da luz em cada superfície que cruza. "
                  "Desligado: o corpo bloqueia a luz, mesmo que seja de vidro."},
      Explanation{TextId::emission, "Luz que a superfície emite por si mesma, iluminada ou não."},
      Explanation{TextId::checker, "Quadrados em duas cores, que multiplicam ka e kd."},
      Explanation{TextId::strength, "L: a cor da luz e quanto há dela; 1 é branco pleno."},
      Explanation{
          TextId::attenuation,
          "Como a luz enfraquece com a distância r: é dividida por c + l r + q r\u00b2. 1, 0, 0 é igual em toda "
          "parte; 0, 0, 1 é como na natureza."},
      Explanation{TextId::background, "A cor que traz um raio que sai da cena."},
      Explanation{TextId::ambient_light, "Luz de toda parte; ka diz quanto dela uma superfície devolve."},
      Explanation{
          TextId::depth_limit,
          "\"depth\" no arquivo da cena: a SHADE mais profunda que pode haver. A do raio primário tem DEPTH 1; um "
          "raio que chamaria uma mais profunda não se forma."},
      Explanation{
          TextId::threshold,
          "\"threshold\" no arquivo da cena: um raio que só poderia trazer menos que esta parte do seu pixel não "
          "se forma. 0,01 é um centésimo."},
  };
  return table;
}

}  // namespace raywalk
