#include "view/predict.h"

namespace raywalk {

std::string_view portuguese(PredictText id) {
  switch (id) {
    case PredictText::ask_way:
      return "Para onde vai o {0}? Arraste uma seta a partir do anel e pressione STEP.";
    case PredictText::way_guessed:
      return "STEP mostra o {0}; arraste de novo para mudar de ideia.";
    case PredictText::ask_end:
      return "O que o {0} vai encontrar? Clique nele, ou na planta vazia para nada; depois STEP.";
    case PredictText::end_guessed:
      return "Seu palpite: {0}. STEP mostra a resposta.";
    case PredictText::nothing:
      return "nada";
    case PredictText::off:
      return "\u2713 Erro de {0}\u00b0.";
    case PredictText::off_too_far:
      return "\u2717 Erro de {0}\u00b0.";
    case PredictText::met_right:
      return "\u2713 Certo: {0}.";
    case PredictText::met_wrong:
      return "\u2717 {0}, n\u00e3o {1}.";
    case PredictText::score:
      return "{0} de {1} certas.";
    case PredictText::idle:
      return "Avance: antes de cada raio h\u00e1 uma pergunta.";
    case PredictText::idle_at_end:
      return "CLEAR recome\u00e7a: antes de cada raio h\u00e1 uma pergunta.";
    case PredictText::nothing_to_save:
      return "Ainda n\u00e3o h\u00e1 previs\u00e3o para salvar";
  }
  return {};
}

}  // namespace raywalk
